#include "game/budget/controller.hpp"

#include <algorithm>

namespace trembler::budget {
namespace {

constexpr double worthSaving = 0.98;
constexpr double nearlyCheapest = 1.05;

std::string nameOf(std::span<KnobFigures const> knobs, std::vector<std::size_t> const& plan) {
    std::string name;
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        name += knobs[i].name + '=' + knobs[i].options[plan[i]].name + ';';
    }
    return name;
}

// The plan holds the cheapest of equally accurate options. Keeps a knob's current option instead if it is no
// less accurate and the budget has room for it, so that nothing changes needlessly.
void keepWhatIsAsGood(std::vector<std::vector<Choice>> const& choices,
                      std::vector<std::size_t> const& current, double room, std::vector<std::size_t>& plan) {
    double cost = 0;
    for (std::size_t i = 0; i < plan.size(); ++i) {
        cost += choices[i][plan[i]].cost;
    }
    for (std::size_t i = 0; i < plan.size(); ++i) {
        Choice const& there = choices[i][current[i]];
        Choice const& planned = choices[i][plan[i]];
        double const more = there.cost - planned.cost;
        if (there.allowed && there.error <= planned.error && cost + more <= room) {
            cost += more;
            plan[i] = current[i];
        }
    }
}

} // namespace

void Controller::forgetPlans() {
    visited_.clear();
    tried_.clear();
    patience_ = 1;
    patientUntil_ = 0;
    quietUntil_ = 0;
}

double Controller::correction(Key const& key, double otherwise) const {
    auto const at = corrections_.find(key);
    return at == corrections_.end() ? otherwise : at->second;
}

double Controller::predicted(KnobFigures const& knob, std::size_t option) const {
    KnobFigures::Option const& now = knob.options[knob.current];
    KnobFigures::Option const& then = knob.options[option];
    double const here = correction({knob.name, now.name}, 1);
    return knob.microseconds * (then.work * correction({knob.name, then.name}, here)) / (now.work * here);
}

void Controller::learn(std::span<KnobFigures const> knobs) {
    for (KnobFigures const& knob : knobs) {
        Key const key{knob.name, knob.options[knob.current].name};
        auto const at = tried_.find(key);
        if (at != tried_.end() && knob.microseconds > 0 && at->second.microseconds > 0) {
            double const ratio = knob.microseconds / at->second.microseconds;
            corrections_[key] = correction(at->second.from, 1) * ratio / at->second.ratioOfWorks;
        }
    }
    tried_.clear();
}

std::vector<std::size_t> Controller::decide(std::span<KnobFigures const> knobs, double rest, double budget) {
    ++round_;
    learn(knobs);
    if (budget != budget_) {
        budget_ = budget;
        forgetPlans();
    }
    std::vector<std::size_t> current;
    std::vector<std::vector<Choice>> choices;
    double now = rest;
    double errorNow = 0;
    bool forced = false;
    for (KnobFigures const& knob : knobs) {
        bool const sleeps = !(knob.microseconds > 0) && knob.options[knob.current].allowed;
        std::vector<Choice> of;
        for (std::size_t i = 0; i < knob.options.size(); ++i) {
            KnobFigures::Option const& option = knob.options[i];
            of.push_back({predicted(knob, i), std::max(option.error, unseen),
                          sleeps ? i == knob.current : option.allowed});
        }
        now += knob.microseconds;
        errorNow += of[knob.current].error;
        forced = forced || !knob.options[knob.current].allowed;
        current.push_back(knob.current);
        choices.push_back(std::move(of));
    }
    visited_.insert(nameOf(knobs, current));
    bool const over = now > budget;
    double cheapest = rest;
    std::vector<std::size_t> const least = bestPlan(choices, 0);
    for (std::size_t i = 0; i < least.size(); ++i) {
        cheapest += choices[i][least[i]].cost;
    }
    hopeless_ = cheapest > roomForLess * budget;
    if (!forced && round_ <= quietUntil_) {
        return current;
    }
    double const aim =
        hopeless_ ? nearlyCheapest * cheapest : (over || forced ? roomForLess : roomForMore) * budget;
    double const room = aim - rest;
    std::vector<std::size_t> plan = bestPlan(choices, room);
    keepWhatIsAsGood(choices, current, room, plan);
    if (plan == current) {
        return current;
    }
    double cost = rest;
    double error = 0;
    for (std::size_t i = 0; i < plan.size(); ++i) {
        cost += choices[i][plan[i]].cost;
        error += choices[i][plan[i]].error;
    }
    bool const saves = over && cost < worthSaving * now;
    if (!forced && !saves) {
        bool const fits = hopeless_ || (!over && cost <= roomForMore * budget);
        if (!fits || error > worthwhile * errorNow || round_ < patientUntil_) {
            return current;
        }
        if (visited_.contains(nameOf(knobs, plan))) {
            patience_ = std::min(2 * patience_, mostPatience);
        }
        patientUntil_ = round_ + patience_;
    }
    for (std::size_t i = 0; i < plan.size(); ++i) {
        if (plan[i] != current[i]) {
            KnobFigures::Option const& from = knobs[i].options[current[i]];
            KnobFigures::Option const& to = knobs[i].options[plan[i]];
            tried_[{knobs[i].name, to.name}] = {
                {knobs[i].name, from.name}, knobs[i].microseconds, to.work / from.work};
        }
    }
    quietUntil_ = round_ + 1;
    return plan;
}

} // namespace trembler::budget
