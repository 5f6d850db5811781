#include "game/budget/budget_mode.hpp"

#include "runtime/level/model/change_fault.hpp"
#include "runtime/level/model/world_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace trembler::budget {
namespace {

double totalOf(std::vector<ComponentStatus> const& all) {
    double total = 0;
    for (ComponentStatus const& status : all) {
        total += status.totalMicroseconds;
    }
    return total;
}

} // namespace

std::string inWords(Decision const& decision) {
    std::string effect = decision.effect;
    if (!effect.empty()) {
        effect[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(effect[0])));
    }
    double const time = std::abs(decision.microseconds);
    return fmt::format("{}: {} -> {}: {} {}, error {:.2g} % {}", effect, decision.from, decision.to,
                       decision.microseconds >= 0 ? "saves" : "costs",
                       time < 9.95    ? fmt::format("{:.1f} µs", time)
                       : time < 999.5 ? fmt::format("{:.0f} µs", time)
                                      : fmt::format("{:.3g} ms", time / 1000),
                       100 * decision.error.share, decision.of);
}

BudgetMode::BudgetMode(Registry const& registry, Stopwatch stopwatch)
    : registry_(registry),
      stopwatch_(stopwatch ? std::move(stopwatch) : [](World const& world) { return world.status(); }) {}

void BudgetMode::clear() {
    log_.clear();
    controller_ = {};
    knobs_.clear();
    knobsStructure_ = 0;
    figures_ = {};
    decisions_.clear();
    lastFrame_ = 0;
    measureFrom_ = 0;
    measuring_ = false;
}

Knob const* BudgetMode::knob(std::string const& effect) const {
    auto const at =
        std::find_if(knobs_.begin(), knobs_.end(), [&](Knob const& k) { return k.effect == effect; });
    return at == knobs_.end() ? nullptr : &*at;
}

double BudgetMode::error() const {
    double sum = 0;
    for (Knob const& knob : knobs_) {
        sum += knob.options[knob.current].error.metres;
    }
    return sum;
}

void BudgetMode::look(World const& world) {
    log_.look(world);
    knobs_ = knobsOf(world, log_);
    for (Knob& knob : knobs_) {
        for (std::size_t i = 0; i < knob.options.size(); ++i) {
            Option& option = knob.options[i];
            for (RecordedChange const& change : option.makes) {
                auto const fault = faultIn(registry_, world, change);
                if (fault && i != knob.current && option.cannot.empty()) {
                    option.cannot = fault->message;
                }
            }
        }
    }
    knobsFrame_ = world.frame();
    knobsStructure_ = world.store().structureVersion();
    knobsOptions_.detail = world.options().detail;
    knobsOptions_.periods = world.options().periods;
}

bool BudgetMode::stale(World const& world) const {
    bool const placed = world.frame() == 0 && knobsStructure_ != world.store().structureVersion();
    return knobsStructure_ == 0 || knobsFrame_ > world.frame() || placed ||
           knobsOptions_.detail != world.options().detail || knobsOptions_.periods != world.options().periods;
}

void BudgetMode::startMeasuring(World const& world) {
    before_.clear();
    auto const all = stopwatch_(world);
    for (ComponentStatus const& status : all) {
        before_[title(*status.info)] = status.totalMicroseconds;
    }
    lastTotal_ = totalOf(all);
    worst_ = 0;
    measureFrom_ = world.frame();
    measuring_ = true;
}

void BudgetMode::beforeStep(Session& session, bool decide) {
    if (!budget_ && !watching_) {
        measuring_ = false;
        return;
    }
    World const& world = session.world();
    std::uint64_t const frame = world.frame();
    if (frame < lastFrame_ || frame == 0) { // another run has begun
        log_.clear();
        controller_.forgetPlans();
        decisions_.clear();
        measuring_ = false;
        measureFrom_ = settling;
    }
    lastFrame_ = frame;
    log_.look(world);
    if (!measuring_) {
        if (frame >= measureFrom_) {
            startMeasuring(world);
        }
        return;
    }
    double const total = totalOf(stopwatch_(world));
    worst_ = std::max(worst_, total - lastTotal_);
    lastTotal_ = total;
    if (frame >= measureFrom_ + round) {
        finishRound(session, decide);
    }
}

void BudgetMode::finishRound(Session& session, bool decide) {
    World const& world = session.world();
    double const frames = static_cast<double>(world.frame() - measureFrom_);
    figures_ = {};
    figures_.frame = world.frame();
    figures_.worst = worst_;
    for (ComponentStatus const& status : stopwatch_(world)) {
        std::string const name = title(*status.info);
        double const each = (status.totalMicroseconds - before_[name]) / frames;
        figures_.componentsTimes[name] = each;
        figures_.effects[std::string(status.info->text.effect)] += each;
        figures_.microseconds += each;
    }
    look(world);
    startMeasuring(world);
    if (budget_ && decide) {
        this->decide(session);
    }
}

void BudgetMode::decide(Session& session) {
    std::vector<KnobFigures> all;
    double rest = figures_.microseconds;
    for (Knob const& knob : knobs_) {
        KnobFigures made;
        made.name = knob.effect;
        made.current = knob.current;
        for (Option const& option : knob.options) {
            made.options.push_back({option.name, option.work, option.error.metres, option.cannot.empty()});
        }
        for (std::string const& component : knob.components) {
            made.microseconds += figures_.componentsTimes[component];
        }
        rest -= made.microseconds;
        all.push_back(std::move(made));
    }
    std::vector<std::size_t> const plan = controller_.decide(all, std::max(rest, 0.0), *budget_);
    bool changed = false;
    for (std::size_t i = 0; i < plan.size(); ++i) {
        Knob& knob = knobs_[i];
        if (plan[i] == knob.current) {
            continue;
        }
        Option const& to = knob.options[plan[i]];
        for (RecordedChange const& change : to.makes) {
            if (!holds(registry_, session.world(), change)) {
                session.change(change);
            }
        }
        decisions_.push_back({session.world().frame() + 1, knob.effect, knob.options[knob.current].name,
                              to.name, all[i].microseconds - controller_.predicted(all[i], plan[i]), to.error,
                              knob.of});
        knob.current = plan[i];
        changed = true;
    }
    if (changed) {
        measuring_ = false;
        measureFrom_ = session.world().frame() + settling;
    }
}

} // namespace trembler::budget
