#include "game/app/options/values/assignments.hpp"

#include "game/app/options/rule/rule.hpp"
#include "game/app/options/values/numbers.hpp"
#include "puzzle/data/effects.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/level/model/detail_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace trembler {
namespace {

constexpr int longestPeriod = 3600; // frames; the limit of World::setPeriod

/// "NAME=VALUE" split at the last '=', as component titles may contain others; nothing if a part is missing.
std::optional<std::pair<std::string, std::string>> splitAtEquals(std::string const& text) {
    std::size_t const at = text.rfind('=');
    if (at == std::string::npos || at == 0 || at + 1 == text.size()) {
        return std::nullopt;
    }
    return std::pair(text.substr(0, at), text.substr(at + 1));
}

/// Why a detail level that exists cannot be chosen on this machine; empty if it can.
std::string whyMissing(Registry const& registry, std::string const& effect, std::string const& level) {
    for (Registration const& registration : registry.components()) {
        ComponentText const& text = registration.info->text;
        if (text.effect == effect && text.level == level && !registration.missing.empty()) {
            return std::string(registration.missing);
        }
    }
    return {};
}

Fault faultOfDetail(std::string const& text) {
    auto const split = splitAtEquals(text);
    if (!split) {
        return "";
    }
    auto const& [effect, level] = *split;
    Registry registry;
    registerEffects(registry);
    auto const all = detailLevels(registry);
    auto const levels = all.find(effect);
    if (levels == all.end()) {
        std::vector<std::string> effects;
        for (auto const& [name, ofIt] : all) {
            effects.push_back(name);
        }
        return fmt::format("no effect '{}' has detail levels{}; effects that have: {}", shown(effect),
                           didYouMean(effect, effects), listed(effects));
    }
    if (std::find(levels->second.begin(), levels->second.end(), level) == levels->second.end()) {
        return fmt::format("{} has no detail level '{}'{}; it has: {}", effect, shown(level),
                           didYouMean(level, levels->second), listed(levels->second));
    }
    std::string const missing = whyMissing(registry, effect, level);
    return missing.empty() ? Fault() : Fault("is not available: " + missing);
}

CLI::Option* addAssignments(CLI::App& command, std::string const& option, std::vector<std::string>& target,
                            std::string const& form, std::string const& meaning) {
    // Without allow_extra_args(false) the option would take the level for its value.
    return oncePerKey(command.add_option(option, target, meaning)->type_name(form)->allow_extra_args(false));
}

} // namespace

CLI::Option* addDetail(CLI::App& command, std::vector<std::string>& target, std::string const& meaning) {
    return accepts(addAssignments(command, "--detail", target, "EFFECT=LEVEL", meaning),
                   "EFFECT=LEVEL as `trembler components` lists them", faultOfDetail);
}

std::map<std::string, std::string> detailOf(std::vector<std::string> const& options) {
    std::map<std::string, std::string> detail;
    for (std::string const& text : options) {
        if (auto const split = splitAtEquals(text)) {
            detail[split->first] = split->second;
        }
    }
    return detail;
}

CLI::Option* addPeriod(CLI::App& command, std::vector<std::string>& target, std::string const& meaning) {
    return accepts(addAssignments(command, "--period", target, "COMPONENT=N", meaning),
                   fmt::format("COMPONENT=N with a whole number N from 1 to {}", longestPeriod),
                   [](std::string const& text) {
                       auto const split = splitAtEquals(text);
                       return split && wholeNumber(split->second, 1, longestPeriod) ? Fault() : Fault("");
                   });
}

std::map<std::string, int> periodsOf(Registry const& registry, std::vector<std::string> const& options) {
    std::vector<std::string> titles;
    std::vector<std::string> known; // by title or name
    for (Registration const& registration : registry.components()) {
        titles.push_back(title(*registration.info));
        known.push_back(titles.back());
        known.emplace_back(registration.info->text.name);
    }
    std::map<std::string, int> periods;
    for (std::string const& text : options) {
        auto const split = splitAtEquals(text);
        auto const period = split ? wholeNumber(split->second, 1, longestPeriod) : std::nullopt;
        if (!period) {
            continue; // was refused
        }
        std::string const& name = split->first;
        std::vector<std::string> meant;
        for (std::size_t i = 0; i < titles.size(); ++i) {
            if (known[2 * i] == name || known[2 * i + 1] == name) {
                meant.push_back(titles[i]);
            }
        }
        if (meant.empty()) {
            throw std::invalid_argument(
                fmt::format("--period {}: there is no component '{}'{}; the components are: {}", shown(text),
                            shown(name), didYouMean(name, known), fmt::join(titles, ", ")));
        }
        if (meant.size() > 1 && std::find(titles.begin(), titles.end(), name) == titles.end()) {
            throw std::invalid_argument(fmt::format("--period {}: '{}' may mean any of these: {}",
                                                    shown(text), shown(name), fmt::join(meant, ", ")));
        }
        periods[name] = static_cast<int>(*period);
    }
    return periods;
}

} // namespace trembler
