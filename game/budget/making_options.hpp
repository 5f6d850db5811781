// What the knobs of all effects are made with.
#pragma once

#include "game/budget/knob.hpp"
#include "runtime/world/world.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::budget {

[[nodiscard]] RecordedChange toLevel(std::string_view effect, std::string_view level);
[[nodiscard]] RecordedChange toPeriod(std::string_view component, int period);
[[nodiscard]] RecordedChange toSetting(std::string_view property, std::string_view field, double value);

/// The components of an effect that are its detail levels, as they are now; only those that the scene's
/// properties would let be constructed.
[[nodiscard]] std::vector<ComponentStatus> levelsOf(World const& world, std::string_view effect);
/// Among them the one that is there.
[[nodiscard]] std::optional<ComponentStatus> working(std::vector<ComponentStatus> const& levels);

/// The usual values and the one that is in use, ascending.
template <class T>
[[nodiscard]] std::vector<T> withCurrent(std::vector<T> usual, T current) {
    bool known = false;
    for (T const& value : usual) {
        known = known || value == current;
    }
    if (!known) {
        auto at = usual.begin();
        while (at != usual.end() && *at < current) {
            ++at;
        }
        usual.insert(at, current);
    }
    return usual;
}

/// The world's settings of one kind, or the default ones.
template <class Settings>
[[nodiscard]] Settings settingsOf(World const& world) {
    auto const* const column = world.store().findColumn<Settings>();
    return column == nullptr || column->empty() ? Settings{} : column->values().front();
}

/// Adds how often it runs to an option: name, change and work.
void runEvery(Option& option, std::string_view component, int period);

/// Errors that have nothing to do with each other.
[[nodiscard]] Error together(Error const& a, Error const& b);

} // namespace trembler::budget
