// The wires that the player has laid between objects.
#pragma once

#include "puzzle/session/lasting_object.hpp"
#include "puzzle/session/placements.hpp"

#include <optional>
#include <string>
#include <vector>

namespace trembler {

/// A wire of the player. Its ends keep their identity when placements change, and with them names.
struct LaidWire {
    LastingObject a;
    LastingObject b;

    [[nodiscard]] bool connects(LastingObject const& x, LastingObject const& y) const {
        return (a == x && b == y) || (a == y && b == x);
    }
    friend bool operator==(LaidWire const&, LaidWire const&) = default;
};

/// The name that an object will have in a world built from these placements; nothing if it will not exist.
[[nodiscard]] std::optional<std::string> nameOf(LastingObject const& object, LevelFile const& level,
                                                Placements::List const& placed);
/// The object of that name in a world built from these placements; nothing if there is none.
[[nodiscard]] std::optional<LastingObject> objectNamed(std::string const& name, LevelFile const& level,
                                                       Placements::List const& placed);
/// The wires between objects that exist with these placements.
[[nodiscard]] std::vector<LaidWire> stillLaid(std::vector<LaidWire> wires, LevelFile const& level,
                                              Placements::List const& placed);
/// The wires by the names of their ends, in canonical order, as buildLevel() and solutions state them.
[[nodiscard]] std::vector<LevelConnection>
connectionsOf(std::vector<LaidWire> const& wires, LevelFile const& level, Placements::List const& placed);

} // namespace trembler
