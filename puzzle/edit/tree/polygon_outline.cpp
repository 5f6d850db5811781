#include "puzzle/edit/tree/polygon_outline.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace trembler::edit {
namespace {

/// Corners of two pieces that differ by less than this, m, are one: files state them to a nanometre.
constexpr double sameCorner = 1e-7;

using CornerKey = std::pair<std::int64_t, std::int64_t>;

CornerKey cornerKey(Vec2 point) {
    return {std::llround(point.x / sameCorner), std::llround(point.y / sameCorner)};
}

} // namespace

std::optional<std::vector<Vec2>> polygonOutline(Shape const& shape) {
    std::map<CornerKey, Vec2> places;
    std::set<std::pair<CornerKey, CornerKey>> edges;
    for (ShapePiece const& piece : shape.pieces) {
        if (piece.form != ShapeForm::polygon || piece.corners.size() < 3) {
            return {};
        }
        std::vector<CornerKey> keys;
        for (Vec2 const corner : piece.corners) {
            Vec2 const at = piece.at + rotated(corner, piece.angle);
            keys.push_back(cornerKey(at));
            places.emplace(keys.back(), at);
        }
        for (std::size_t i = 0; i < keys.size(); ++i) {
            edges.emplace(keys[i], keys[(i + 1) % keys.size()]);
        }
    }
    std::map<CornerKey, CornerKey>
        next; // along the outline: edges that no other piece has in the other direction
    for (auto const& [from, to] : edges) {
        if (!edges.contains({to, from}) && !next.emplace(from, to).second) {
            return {}; // it touches itself
        }
    }
    if (next.empty()) {
        return {};
    }
    std::vector<Vec2> outline;
    CornerKey at = cornerKey(shape.pieces.front().at +
                             rotated(shape.pieces.front().corners.front(), shape.pieces.front().angle));
    CornerKey const first = next.contains(at) ? at : next.begin()->first;
    at = first;
    do {
        outline.push_back(places.at(at));
        auto const on = next.find(at);
        if (on == next.end()) {
            return {};
        }
        at = on->second;
    } while (at != first && outline.size() <= next.size());
    return outline.size() == next.size() ? std::optional(std::move(outline)) : std::nullopt;
}

} // namespace trembler::edit
