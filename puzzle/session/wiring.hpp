// The wires that the player has laid between objects.
#pragma once

#include "puzzle/session/lasting_object.hpp"
#include "puzzle/session/placements.hpp"
#include "runtime/level/model/part_library.hpp"

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

/// The names of all objects that a level and placed parts become. Both, and the library, must outlive it.
class WireEnds {
public:
    WireEnds(LevelFile const& level, PartLibrary const& parts, Placements::List const& placed)
        : level_(level), parts_(parts), placed_(placed) {}

    /// The name that an object will have in a world built from these placements; nothing if it will not
    /// exist. Of a composite, its main piece has the name of the whole.
    [[nodiscard]] std::optional<std::string> nameOf(LastingObject const& object) const;
    /// The object of that name in such a world; nothing if there is none.
    [[nodiscard]] std::optional<LastingObject> objectNamed(std::string const& name) const;

private:
    [[nodiscard]] std::vector<std::string> namesOfPlaced() const;

    LevelFile const& level_;
    PartLibrary const& parts_;
    Placements::List const& placed_;
};

/// The wires between objects that exist with these placements.
[[nodiscard]] std::vector<LaidWire> stillLaid(std::vector<LaidWire> wires, WireEnds const& ends);
/// The wires by the names of their ends, in canonical order, as buildLevel() and solutions state them.
[[nodiscard]] std::vector<LevelConnection> connectionsOf(std::vector<LaidWire> const& wires,
                                                         WireEnds const& ends);

} // namespace trembler
