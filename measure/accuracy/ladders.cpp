#include "measure/accuracy/ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace trembler::accuracy {

std::string substepsName(int substeps) {
    return substeps == 0 ? "automatic substeps"
                         : fmt::format("{} substep{}", substeps, substeps == 1 ? "" : "s");
}

std::vector<Plan> plans() {
    std::vector<Plan> all;
    addDynamicsPlans(all);
    addGravityPlans(all);
    addElectricityPlans(all);
    addMagnetismPlans(all);
    addBuoyancyPlans(all);
    addSoundPlans(all);
    addCoSimulationPlans(all);
    return all;
}

namespace {

constexpr double sameTime = 1.05;

// Whether a is at least as good in both error and time and better in one.
bool beats(Rung const& a, Rung const& b) {
    bool const faster = a.microseconds * sameTime < b.microseconds;
    bool const asFast = a.microseconds < b.microseconds * sameTime;
    return (faster && a.error <= b.error) || (asFast && a.error < b.error);
}

} // namespace

void markFront(Ladder& ladder) {
    for (Rung& rung : ladder.rungs) {
        rung.beatenBy.clear();
        if (ladder.rivals) {
            auto const better = std::find_if(ladder.rungs.begin(), ladder.rungs.end(),
                                             [&](Rung const& other) { return beats(other, rung); });
            rung.beatenBy = better == ladder.rungs.end() ? "" : better->level;
        }
        rung.onFront = ladder.rivals && rung.beatenBy.empty();
    }
}

std::vector<Ladder> climb(GameData const& gameData, std::vector<std::string> const& effects, Effort effort,
                          std::function<void(std::string const&)> const& progress) {
    std::vector<Plan> const all = plans();
    for (std::string const& effect : effects) {
        if (std::none_of(all.begin(), all.end(), [&](Plan const& plan) { return plan.effect == effect; })) {
            std::string known;
            for (Plan const& plan : all) {
                if (known.find(plan.effect) == std::string::npos) {
                    known += (known.empty() ? "" : ", ") + plan.effect;
                }
            }
            throw std::invalid_argument(fmt::format(
                "no ladder for the effect \"{}\"; the effects with ladders are: {}", effect, known));
        }
    }
    std::vector<Ladder> ladders;
    for (Plan const& plan : all) {
        if (effects.empty() || std::find(effects.begin(), effects.end(), plan.effect) != effects.end()) {
            if (progress) {
                progress(plan.effect);
            }
            Ladder ladder = plan.climb(gameData, effort);
            for (int run = 1; run < effort.runs; ++run) {
                Ladder const again = plan.climb(gameData, effort);
                for (std::size_t i = 0; i < ladder.rungs.size(); ++i) {
                    ladder.rungs[i].microseconds =
                        std::min(ladder.rungs[i].microseconds, again.rungs[i].microseconds);
                }
            }
            ladder.effect = plan.effect;
            for (Rung& rung : ladder.rungs) {
                if (rung.cannotRepresent.empty()) {
                    rung.cannotRepresent = whatLevelCannotRepresent(ladder.effect, rung.level);
                }
            }
            markFront(ladder);
            ladders.push_back(std::move(ladder));
        }
    }
    return ladders;
}

} // namespace trembler::accuracy
