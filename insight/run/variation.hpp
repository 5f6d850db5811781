// A variation of a run: a solution, and the entries that are left out of the level and of it.
#pragma once

#include "runtime/level/model/level.hpp"

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace trembler::insight {

/// One thing that a run does without.
struct LeftOut {
    enum class Kind : std::uint8_t {
        placement, ///< of the solution, by index
        wire,      ///< that the solution lays, by index
        input,     ///< of the solution, by index
        contact,   ///< two objects pass through each other from a frame on, by their names
        dip,       ///< a liquid does not act on an object from a frame on, by their names
        device,    ///< a magnet or a motor does nothing from a frame on, by its name
        switching, ///< an electromagnet is not switched from a frame on, by its name
        effect,    ///< of physics, by name, see dispensableGameEffects()
    };
    Kind kind = Kind::placement;
    std::size_t index = 0;  ///< in the solution's list
    std::string a{};        ///< contact, dip, device, switching: a name; effect: its name
    std::string b{};        ///< contact: the other name; dip: the liquid's
    std::uint64_t from = 1; ///< contact, dip, device, switching: the first frame without it

    friend auto operator<=>(LeftOut const&, LeftOut const&) = default;
};

[[nodiscard]] LeftOut withoutPlacement(std::size_t index);
[[nodiscard]] LeftOut withoutWire(std::size_t index);
[[nodiscard]] LeftOut withoutInput(std::size_t index);
/// The names in either order.
[[nodiscard]] LeftOut withoutContact(std::string a, std::string b, std::uint64_t from = 1);
[[nodiscard]] LeftOut withoutDip(std::string object, std::string liquid, std::uint64_t from = 1);
[[nodiscard]] LeftOut withoutDevice(std::string object, std::uint64_t from);
[[nodiscard]] LeftOut withoutSwitching(std::string magnet, std::uint64_t from);
[[nodiscard]] LeftOut withoutEffect(std::string name);

/// The order of `leftOut` does not matter, and neither do repeats.
struct Variation {
    /// Where parts are placed, wires laid and inputs given. A caller that changes something instead of
    /// leaving it out changes it here.
    Solution solution;
    std::vector<LeftOut> leftOut{};
    /// N, of each hand, in place of what the level states.
    std::optional<double> handStrength{};
};

} // namespace trembler::insight
