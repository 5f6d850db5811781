#include "physics/dynamics/properties/crowd.hpp"

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {

std::size_t piecesStatedIn(Store const& store) {
    std::size_t count = 0;
    if (auto const* const shapes = store.findColumn<Shape>()) {
        for (Shape const& shape : shapes->values()) {
            count += shape.pieces.size();
        }
    }
    return count;
}

CrowdPieces crowdPiecesOf(Store const& store) {
    CrowdPieces pieces;
    auto const* const shapes = store.findColumn<Shape>();
    auto const* const positions = store.findColumn<Position>();
    auto const* const rotations = store.findColumn<Rotation>();
    auto const* const liquids = store.findColumn<Liquid>();
    auto const* const fixed = store.findColumn<Fixed>();
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
            pieces.movable.push_back(fixed == nullptr || !fixed->has(id));
        }
    }
    return pieces;
}

namespace {

/// The number of near pairs of pieces of one movable body, which no engine compares. A body has few pieces.
std::size_t pairsWithinBodies(CrowdPieces const& pieces) {
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < pieces.boxes.size(); ++i) {
        for (std::size_t j = i + 1;
             pieces.movable[i] && j < pieces.boxes.size() && pieces.bodies[j] == pieces.bodies[i]; ++j) {
            pairs += pieces.boxes[i].meets(pieces.boxes[j]) ? 1 : 0;
        }
    }
    return pairs;
}

} // namespace

std::optional<CrowdedStart> crowdedStart(Store const& store) {
    constexpr std::size_t few = 20'000;
    constexpr std::size_t ofAPiece = 16;
    if (std::size_t const count = piecesStatedIn(store); count * (count / 2 + 1) <= few) {
        return std::nullopt;
    }
    CrowdPieces const pieces = crowdPiecesOf(store);
    std::vector<Bounds> movable;
    for (std::size_t i = 0; i < pieces.boxes.size(); ++i) {
        if (pieces.movable[i]) {
            movable.push_back(pieces.boxes[i]);
        }
    }
    BoxTree const all(pieces.boxes);
    BoxTree const moving(movable);
    CrowdedStart crowd{.pairs = 0, .usual = few + ofAPiece * movable.size(), .body = {}, .nearest = 0};
    std::size_t ofMovables = 0; // pairs of two movable pieces, each counted twice
    for (std::size_t i = 0; i < pieces.boxes.size(); ++i) {
        if (!pieces.movable[i]) {
            continue;
        }
        std::size_t const near = std::max<std::size_t>(1, all.count(pieces.boxes[i])) - 1; // less itself
        ofMovables += std::max<std::size_t>(1, moving.count(pieces.boxes[i])) - 1;
        crowd.pairs += near;
        if (near > crowd.nearest) {
            crowd.nearest = near;
            crowd.body = pieces.bodies[i];
        }
    }
    crowd.pairs -= ofMovables / 2 + pairsWithinBodies(pieces);
    return crowd.pairs > crowd.usual ? std::optional(crowd) : std::nullopt;
}

std::string inWords(CrowdedStart const& crowd, std::string const& name) {
    return fmt::format(
        "{} pairs of pieces of bodies lie in one another or side by side at the start, so each "
        "frame takes long; the box around a piece of '{}' meets those around {} others",
        crowd.pairs, name, crowd.nearest);
}

} // namespace trembler
