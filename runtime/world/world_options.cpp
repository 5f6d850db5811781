// Changing detail levels and periods between two frames.
#include "runtime/world/world.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <stdexcept>
#include <utility>

namespace trembler {

void World::setDetail(std::string const& effect, std::string const& level) {
    std::set<std::string_view> effects;
    std::set<std::string_view> levels;
    for (Entry const& entry : entries_) {
        ComponentText const& text = entry.status.info->text;
        if (!text.level.empty()) {
            effects.insert(text.effect);
            if (text.effect == effect) {
                levels.insert(text.level);
            }
            if (text.effect == effect && text.level == level && !entry.registration->missing.empty()) {
                throw std::invalid_argument(
                    fmt::format("{}={} is not available: {}", effect, level, entry.registration->missing));
            }
        }
    }
    if (levels.empty()) {
        throw std::invalid_argument(fmt::format("no effect '{}' has detail levels; effects that have: {}",
                                                effect, fmt::join(effects, ", ")));
    }
    std::map<std::string, std::string> before = options_.detail;
    if (level.empty()) {
        options_.detail.erase(effect);
    } else if (levels.contains(level)) {
        options_.detail[effect] = level;
    } else {
        throw std::invalid_argument(
            fmt::format("{} has no detail level '{}'; it has: {}", effect, level, fmt::join(levels, ", ")));
    }
    if (knownStructure_ != 0) {
        try {
            select();
        } catch (...) { // of a component's constructor
            options_.detail.swap(before);
            throw;
        }
    }
}

void World::setPeriod(std::string const& componentTitle, int period) {
    if (period < 0 || period > 3600) {
        throw std::invalid_argument(
            fmt::format("the period of '{}' is {}; expected 1 to 3600 frames", componentTitle, period));
    }
    std::vector<std::string> titles;
    std::vector<Entry*> named;
    for (Entry& entry : entries_) {
        titles.push_back(title(*entry.status.info));
        if (titles.back() == componentTitle) {
            named.assign(1, &entry); // a full title has precedence over a name
            break;
        }
        if (entry.status.info->text.name == componentTitle) {
            named.push_back(&entry);
        }
    }
    if (named.size() > 1) {
        titles.clear();
        for (Entry const* entry : named) {
            titles.push_back(title(*entry->status.info));
        }
        throw std::invalid_argument(
            fmt::format("'{}' may mean any of these: {}", componentTitle, fmt::join(titles, ", ")));
    }
    if (named.empty()) {
        throw std::invalid_argument(fmt::format("there is no component '{}'; the components are: {}",
                                                componentTitle, fmt::join(titles, ", ")));
    }
    bool const leftOut = period == 0;
    if (leftOut && named.front()->status.info->kind != ComponentKind::interaction) {
        throw std::invalid_argument(fmt::format(
            "the period of '{}' is 0; expected 1 to 3600 frames: only interactions can be left out",
            componentTitle));
    }
    for (std::vector<Turn>& turns : turns_) {
        for (Turn& turn : turns) {
            wake(turn); // a component with a period does not have a turn in every part
        }
    }
    bool const wasLeftOut = std::exchange(named.front()->status.period, period) == 0;
    options_.periods[title(*named.front()->status.info)] = period;
    if (leftOut != wasLeftOut && knownStructure_ != 0) {
        select();
    }
}

} // namespace trembler
