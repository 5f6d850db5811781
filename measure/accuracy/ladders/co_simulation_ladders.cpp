// Co-simulation ladders: the energy that one frame of lag between simulations adds or removes.
#include "measure/accuracy/ladder.hpp"
#include "measure/accuracy/ladders/co_simulation.hpp"
#include "puzzle/data/game_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace trembler::accuracy {
namespace {

[[maybe_unused]] constexpr std::array<int, 5> substepCounts{1, 2, 4, 8, 16};
[[maybe_unused]] constexpr std::array<int, 4> partCounts{1, 2, 4, 8};

// A ladder whose remark states the largest deviation of the measured growth from the predicted one.
class Growth {
public:
    explicit Growth(std::string scene) {
        ladder_.scene = std::move(scene);
        ladder_.unit = "of the energy";
        ladder_.error = "change of the energy in an oscillation, over five of them";
        ladder_.reference = "conserved (closed form)";
        ladder_.rivals = false;
    }
    void add(std::string level, Swing const& swing) {
        ladder_.rungs.push_back(
            {std::move(level), swing.microseconds, std::abs(swing.growth), {}, false, {}});
        worst_ = std::max(worst_, std::abs(swing.growth - swing.predicted));
    }
    [[nodiscard]] Ladder finish(std::string const& remark) {
        ladder_.remark =
            fmt::format("{} Theory and measurement differ by {:.1g} of the energy at most.", remark, worst_);
        return std::move(ladder_);
    }

private:
    Ladder ladder_;
    double worst_ = 0;
};

Ladder climbMagnet(GameData const& gameData, Effort) {
    Growth growth("a magnet on a spring, pushed by another");
    for (int const substeps : substepCounts) {
        growth.add(substepsName(substeps) + ", late", magnetOnSpring(gameData, substeps, false));
    }
    for (int const substeps : substepCounts) {
        growth.add(substepsName(substeps) + ", ahead", magnetOnSpring(gameData, substeps, true));
    }
    for (int const parts : partCounts) {
        growth.add(fmt::format("16 substeps, late, in {} part{}", parts, parts == 1 ? "" : "s"),
                   magnetOnSpring(gameData, 16, false, parts));
    }
    return growth.finish(
        "A force that is computed once in a frame of the length t, and held for it, is late by t/2 on "
        "average. Where it is late by τ, amplitudes grow at the rate ½ τ F'/m, F' being its stiffness, and "
        "energies twice as fast (Åström and Wittenmark, Computer-Controlled Systems, 1997, on sample and "
        "hold). N substeps of semi-implicit Euler leave τ = t/2 (1 - 1/N): one has no lag, and more of them "
        "do not help, as they remove the part that compensates the lag. The spring, which belongs to "
        "dynamics, has no such lag; Box2D's implicit steps take energy out of it, the less the shorter they "
        "are. With one substep this is the only change, and the oscillation loses energy; with more it gains "
        "energy. Looking ahead, the default, uses the force at the position that the magnet has after τ. *In "
        "parts* a "
        "frame is "
        "computed in several equal parts (`\"frame\": {\"parts\": 4}`), in each of which the force is "
        "computed "
        "again: t is a part, and so is the lag.");
}

Ladder climbFloat(GameData const& gameData, Effort) {
    Growth growth("a float on a spring");
    for (int const substeps : substepCounts) {
        growth.add(substepsName(substeps) + ", late", floatOnSpring(gameData, substeps, 1, false));
    }
    for (int const period : {2, 4}) {
        growth.add(fmt::format("4 substeps, late, every {} frames", period),
                   floatOnSpring(gameData, 4, period, false));
    }
    for (int const substeps : substepCounts) {
        growth.add(substepsName(substeps) + ", ahead", floatOnSpring(gameData, substeps, 1, true));
    }
    for (int const period : {2, 4}) {
        growth.add(fmt::format("4 substeps, ahead, every {} frames", period),
                   floatOnSpring(gameData, 4, period, true));
    }
    return growth.finish(
        "*Late* are forces as in the thesis, with the same lag as the magnet's: with one substep the "
        "oscillation loses energy, otherwise it gains energy. *Ahead* is the default, looking ahead "
        "([buoyancy.md](../buoyancy.md)), which resists the float's motion by the average change of the "
        "force until it is computed again. The remaining loss is that of the spring in the engine.");
}

} // namespace

void addCoSimulationPlans(std::vector<Plan>& plans) {
    plans.push_back({"co-simulation", climbMagnet});
    plans.push_back({"co-simulation", climbFloat});
}

} // namespace trembler::accuracy
