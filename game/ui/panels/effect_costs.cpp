// Collects the figures for the rows of the panel: levels, times and reasons by effect.
#include "game/ui/panels/cost_rows.hpp"
#include "game/ui/shared/words.hpp"

#include <algorithm>
#include <map>

namespace trembler::ui {
namespace {

/// Why a component is absent, in words.
std::string reasonOf(ComponentStatus const& status) {
    switch (status.choice.reason) {
    case ChoiceReason::noObjects: {
        // Without a property it needs any one of several: the first stands for them.
        PropertyInfo const* const missing =
            status.choice.property != nullptr ? status.choice.property : status.info->neededAny.front();
        return words::nothingHas(missing->text.name);
    }
    case ChoiceReason::notRead:
        return words::notRead;
    default:
        return words::notNeeded;
    }
}

} // namespace

std::vector<EffectLevels> effectLevels(World const& world) {
    struct Known {
        int cost;
        std::string level;
        bool working;
    };
    std::map<std::string, std::vector<Known>> byEffect;
    for (ComponentStatus const& status : world.status()) {
        ComponentText const& text = status.info->text;
        if (!text.level.empty()) {
            byEffect[std::string(text.effect)].push_back(
                {text.rank, std::string(text.level), status.activity != Activity::absent});
        }
    }
    std::vector<EffectLevels> all;
    for (auto& [effect, known] : byEffect) {
        std::stable_sort(known.begin(), known.end(),
                         [](Known const& a, Known const& b) { return a.cost < b.cost; });
        EffectLevels levels{effect, {}, {}, {}};
        for (Known const& one : known) {
            if (std::find(levels.levels.begin(), levels.levels.end(), one.level) == levels.levels.end()) {
                levels.levels.push_back(one.level);
            }
            if (one.working) {
                levels.working = one.level;
            }
        }
        auto const stated = world.options().detail.find(effect);
        levels.chosen = stated == world.options().detail.end() ? "" : stated->second;
        if (levels.levels.size() > 1) {
            all.push_back(std::move(levels));
        }
    }
    return all;
}

std::vector<EffectCost> effectCosts(World const& world, budget::BudgetMode const& mode) {
    std::map<std::string, EffectCost> all;
    bool const measured = mode.figures().frame > 0 && mode.figures().frame <= world.frame();
    auto const busier = [](Activity a, Activity b) {
        return a == Activity::active || b == Activity::active   ? Activity::active
               : a == Activity::asleep || b == Activity::asleep ? Activity::asleep
                                                                : Activity::absent;
    };
    for (ComponentStatus const& status : world.status()) {
        std::string const effect(status.info->text.effect);
        EffectCost& cost = all[effect];
        cost.effect = effect;
        if (cost.reason.empty() || !status.info->text.level.empty()) {
            cost.reason = reasonOf(status);
        }
        cost.activity = busier(cost.activity, status.activity);
        if (!measured && status.activity == Activity::active) {
            cost.microseconds += status.lastMicroseconds / status.period;
        }
    }
    std::vector<EffectCost> list;
    for (auto& [effect, cost] : all) {
        if (measured) {
            auto const at = mode.figures().effects.find(effect);
            cost.microseconds = at == mode.figures().effects.end() ? 0 : at->second;
        }
        if (cost.activity != Activity::absent) {
            cost.reason.clear();
        }
        list.push_back(std::move(cost));
    }
    return list;
}

} // namespace trembler::ui
