#include "puzzle/session/wiring.hpp"

#include "runtime/level/build/placing.hpp"

#include <algorithm>
#include <tuple>

namespace trembler {
namespace {

/// The names of placed parts, by their index in the list.
std::vector<std::string> namesOfPlaced(LevelFile const& level, Placements::List const& placed) {
    std::vector<Placement> const placements = placementsOf(placed);
    std::vector<std::size_t> const order = canonicalOrder(placements);
    std::vector<std::string> const sorted = placementNames(level, placements);
    std::vector<std::string> names(placed.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        names[order[i]] = sorted[i];
    }
    return names;
}

} // namespace

std::optional<std::string> nameOf(LastingObject const& object, LevelFile const& level,
                                  Placements::List const& placed) {
    if (object.kind == Origin::Kind::object && object.number < level.objects.size()) {
        return level.objects[object.number].name;
    }
    if (object.kind == Origin::Kind::placement) {
        for (std::size_t i = 0; i < placed.size(); ++i) {
            if (static_cast<std::uint64_t>(placed[i].number) == object.number) {
                return namesOfPlaced(level, placed)[i];
            }
        }
    }
    return std::nullopt;
}

std::optional<LastingObject> objectNamed(std::string const& name, LevelFile const& level,
                                         Placements::List const& placed) {
    for (std::size_t i = 0; i < level.objects.size(); ++i) {
        if (level.objects[i].name == name) {
            return LastingObject{Origin::Kind::object, i, {}};
        }
    }
    std::vector<std::string> const names = namesOfPlaced(level, placed);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == name) {
            return LastingObject{Origin::Kind::placement, static_cast<std::uint64_t>(placed[i].number), {}};
        }
    }
    return std::nullopt;
}

std::vector<LaidWire> stillLaid(std::vector<LaidWire> wires, LevelFile const& level,
                                Placements::List const& placed) {
    std::erase_if(wires, [&](LaidWire const& wire) {
        return !nameOf(wire.a, level, placed) || !nameOf(wire.b, level, placed);
    });
    return wires;
}

std::vector<LevelConnection> connectionsOf(std::vector<LaidWire> const& wires, LevelFile const& level,
                                           Placements::List const& placed) {
    std::vector<LevelConnection> all;
    for (LaidWire const& wire : wires) {
        std::string a = nameOf(wire.a, level, placed).value_or("");
        std::string b = nameOf(wire.b, level, placed).value_or("");
        if (b < a) {
            std::swap(a, b);
        }
        all.push_back({.a = std::move(a), .b = std::move(b), .path = {}, .kind = std::string(playersWire)});
    }
    std::sort(all.begin(), all.end(), [](LevelConnection const& x, LevelConnection const& y) {
        return std::tie(x.a, x.b) < std::tie(y.a, y.b);
    });
    return all;
}

} // namespace trembler
