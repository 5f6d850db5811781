#include "physics/dynamics/rules/crowd_rules.hpp"

#include "physics/box_tree.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/overlap.hpp"
#include "physics/dynamics/properties/shape_rules.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

namespace trembler {
namespace {

struct CrowdPieces {
    std::vector<Bounds> boxes;
    std::vector<ObjectId> bodies; // the body of each piece
};

std::size_t pieceCount(Store const& store) {
    std::size_t count = 0;
    if (auto const* const shapes = store.findColumn<Shape>()) {
        for (Shape const& shape : shapes->values()) {
            count += shape.pieces.size();
        }
    }
    return count;
}

CrowdPieces piecesOf(Store const& store) {
    CrowdPieces pieces;
    auto const* const shapes = store.findColumn<Shape>();
    auto const* const positions = store.findColumn<Position>();
    auto const* const rotations = store.findColumn<Rotation>();
    auto const* const liquids = store.findColumn<Liquid>();
    if (shapes == nullptr || positions == nullptr) {
        return pieces;
    }
    Shape alone{std::vector<ShapePiece>(1)};
    for (std::size_t row = 0; row < shapes->size(); ++row) {
        ObjectId const id = shapes->owners()[row];
        Shape const& shape = shapes->values()[row];
        Position const* const position = positions->find(id);
        if (position == nullptr || (liquids != nullptr && liquids->has(id)) || faultIn(shape)) {
            continue; // no body; other rules report its faults
        }
        Rotation const* const rotation = rotations == nullptr ? nullptr : rotations->find(id);
        for (ShapePiece const& piece : shape.pieces) {
            alone.pieces.front() = piece;
            auto const [lower, upper] =
                extentOf({alone, position->value, rotation == nullptr ? 0 : rotation->angle});
            pieces.boxes.push_back({lower, upper});
            pieces.bodies.push_back(id);
        }
    }
    return pieces;
}

} // namespace

std::vector<ObjectFault> checkCrowds(Store const& store, std::size_t most) {
    if (std::size_t const count = pieceCount(store); count * (count / 2 + 1) <= most) {
        return {}; // too few pieces to exceed the limit
    }
    CrowdPieces const pieces = piecesOf(store);
    BoxTree const tree(pieces.boxes);
    std::size_t sum = 0; // number of pairs, each counted twice
    std::size_t nearest = 0;
    std::size_t crowded = 0; // the piece that is near the most others
    for (std::size_t i = 0; i < pieces.boxes.size() && sum <= 2 * most; ++i) {
        std::size_t const near = std::max<std::size_t>(1, tree.count(pieces.boxes[i])) - 1; // itself
        sum += near;
        if (near > nearest) {
            nearest = near;
            crowded = i;
        }
    }
    if (sum <= 2 * most) {
        return {};
    }
    return {
        {pieces.bodies[crowded], fmt::format("too many bodies lie in one place: the box around one of its "
                                             "pieces meets those around {} others; expected "
                                             "at most {} pairs of pieces of which the surrounding boxes meet",
                                             nearest, most)}};
}

std::vector<ObjectFault> checkCrowds(Store const& store) {
    return checkCrowds(store, mostNearPairs);
}

} // namespace trembler
