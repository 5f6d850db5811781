#include "puzzle/edit/tree/extent.hpp"

#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "puzzle/edit/tree/entry_pieces.hpp"
#include "puzzle/edit/tree/object_values.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace trembler::edit {
namespace {

using Extent = std::pair<Vec2, Vec2>; // lower left and upper right corner, m

/// Makes an extent, if there is one yet, large enough for another one as well.
void include(std::optional<Extent>& all, Extent const& other) {
    auto const& [low, high] = other;
    if (!all) {
        all = other;
    }
    all->first = {std::min(all->first.x, low.x), std::min(all->first.y, low.y)};
    all->second = {std::max(all->second.x, high.x), std::max(all->second.y, high.y)};
}

/// Around all objects that an entry becomes; nothing if none has a shape.
std::optional<Extent> extentOfPieces(GameData const& data, Json const& entry) {
    std::optional<Extent> all;
    for (PropertySet const& piece : piecesOf(data, entry)) {
        Shape const* const shape = piece.find<Shape>();
        if (shape == nullptr || faultIn(*shape)) {
            continue;
        }
        auto const* const position = piece.find<Position>();
        auto const* const rotation = piece.find<Rotation>();
        include(all, extentOf(PlacedShape{*shape, position == nullptr ? Vec2{} : position->value,
                                          rotation == nullptr ? 0 : rotation->angle}));
    }
    return all;
}

/// The extent of one entry.
Extent extentOfEntry(GameData const& data, Json const& entry) {
    Vec2 const at = placeOf(entry);
    if (isComposite(data, entry) || entry.contains("flipped")) {
        return extentOfPieces(data, entry).value_or(std::pair(at, at));
    }
    auto const shape = shapeOf(data, entry);
    if (!shape || faultIn(*shape)) {
        return {at, at};
    }
    return extentOf(PlacedShape{*shape, at, radians(angleOf(entry))});
}

} // namespace

std::optional<Box> extentOfObjects(GameData const& data, Json const& level,
                                   std::vector<std::string> const& names) {
    std::optional<Extent> all;
    std::set<std::string> const wanted(names.begin(), names.end());
    Json const* const list = findList(level, "objects");
    if (list == nullptr) {
        return {};
    }
    for (Json const& entry : *list) {
        if (wanted.contains(textOf(entry, "name"))) {
            include(all, extentOfEntry(data, entry));
        }
    }
    return all ? std::optional(Box{all->first, all->second - all->first}) : std::nullopt;
}

} // namespace trembler::edit
