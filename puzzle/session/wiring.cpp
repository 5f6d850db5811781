#include "puzzle/session/wiring.hpp"

#include "runtime/level/build/placed_pieces.hpp"
#include "runtime/level/build/placing.hpp"

#include <algorithm>
#include <tuple>

namespace trembler {
namespace {

std::optional<std::string> nameOfPiece(EntryNames const& names, std::string const& entry,
                                       std::uint32_t piece) {
    if (piece >= names.objects.size()) {
        return std::nullopt; // the part is another one now, or cannot be made
    }
    return piece == names.main ? entry : names.objects[piece];
}

/// The piece of that name among the objects of an entry.
std::optional<std::uint32_t> pieceNamed(EntryNames const& names, std::string const& entry,
                                        std::string const& wanted) {
    if (wanted == entry) {
        return static_cast<std::uint32_t>(names.main);
    }
    auto const at = std::find(names.objects.begin(), names.objects.end(), wanted);
    return at == names.objects.end() ? std::nullopt
                                     : std::optional(static_cast<std::uint32_t>(at - names.objects.begin()));
}

/// Whether an object can belong to an entry: its pieces are named "ENTRY PIECE".
bool mayBeOf(std::string const& entry, std::string const& object) {
    return object == entry || object.starts_with(entry + " ");
}

} // namespace

std::vector<std::string> WireEnds::namesOfPlaced() const {
    std::vector<Placement> const placements = placementsOf(placed_);
    std::vector<std::size_t> const order = canonicalOrder(placements);
    std::vector<std::string> const sorted = placementNames(level_, placements);
    std::vector<std::string> names(placed_.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        names[order[i]] = sorted[i];
    }
    return names;
}

std::optional<std::string> WireEnds::nameOf(LastingObject const& object) const {
    if (object.kind == Origin::Kind::object && object.number < level_.objects.size()) {
        LevelObject const& entry = level_.objects[object.number];
        return nameOfPiece(namesOf(parts_, entry), entry.name, object.piece);
    }
    if (object.kind == Origin::Kind::placement) {
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            if (static_cast<std::uint64_t>(placed_[i].number) == object.number) {
                std::string const name = namesOfPlaced()[i];
                return nameOfPiece(namesOf(parts_, entryOf(placed_[i].placement, name)), name, object.piece);
            }
        }
    }
    return std::nullopt;
}

std::optional<LastingObject> WireEnds::objectNamed(std::string const& name) const {
    for (std::size_t i = 0; i < level_.objects.size(); ++i) {
        LevelObject const& entry = level_.objects[i];
        if (!mayBeOf(entry.name, name)) {
            continue;
        }
        if (auto const piece = pieceNamed(namesOf(parts_, entry), entry.name, name)) {
            return LastingObject{Origin::Kind::object, i, {}, *piece};
        }
    }
    std::vector<std::string> const names = namesOfPlaced();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!mayBeOf(names[i], name)) {
            continue;
        }
        EntryNames const pieces = namesOf(parts_, entryOf(placed_[i].placement, names[i]));
        if (auto const piece = pieceNamed(pieces, names[i], name)) {
            auto const number = static_cast<std::uint64_t>(placed_[i].number);
            return LastingObject{Origin::Kind::placement, number, {}, *piece};
        }
    }
    return std::nullopt;
}

std::vector<LaidWire> stillLaid(std::vector<LaidWire> wires, WireEnds const& ends) {
    std::erase_if(wires, [&](LaidWire const& wire) { return !ends.nameOf(wire.a) || !ends.nameOf(wire.b); });
    return wires;
}

std::vector<LevelConnection> connectionsOf(std::vector<LaidWire> const& wires, WireEnds const& ends) {
    std::vector<LevelConnection> all;
    for (LaidWire const& wire : wires) {
        std::string a = ends.nameOf(wire.a).value_or("");
        std::string b = ends.nameOf(wire.b).value_or("");
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
