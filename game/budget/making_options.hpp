// Helpers that build the options of all knobs.
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

/// The components that are the detail levels of an effect, with their current status; only the components
/// that the scene's properties allow to be constructed.
[[nodiscard]] std::vector<ComponentStatus> levelsOf(World const& world, std::string_view effect);
/// The one of `levels` that is constructed, if any.
[[nodiscard]] std::optional<ComponentStatus> working(std::vector<ComponentStatus> const& levels);

/// The usual values and the current one, ascending and without duplicates.
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

/// The world's settings of one kind, or the defaults if it has none.
template <class Settings>
[[nodiscard]] Settings settingsOf(World const& world) {
    auto const* const column = world.store().findColumn<Settings>();
    return column == nullptr || column->empty() ? Settings{} : column->values().front();
}

/// Adds the component's period (frames) to an option: to its name, its changes, its work and lessOften.
void runEvery(Option& option, std::string_view component, int period);

/// The sum of two independent errors: root of the sum of the squares.
[[nodiscard]] Error together(Error const& a, Error const& b);

} // namespace trembler::budget
