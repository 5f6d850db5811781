#include "physics/buoyancy/liquid_rules.hpp"

#include "physics/buoyancy/liquid.hpp"
#include "physics/buoyancy/liquid_area.hpp"
#include "physics/buoyancy/moments.hpp"
#include "physics/dynamics/body.hpp"
#include "physics/dynamics/shape_rules.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

namespace trembler {
namespace {

// Overlaps up to here are rounding, in the numbers of whoever wrote the level.
constexpr double allowedOverlap = 1e-4; // m²

struct Placed {
    Shape const* shape = nullptr;
    Pose pose;
};

std::optional<Placed> placedLiquid(Store const& store, ObjectId id) {
    auto const* const shapes = store.findColumn<Shape>();
    auto const* const positions = store.findColumn<Position>();
    auto const* const rotations = store.findColumn<Rotation>();
    Shape const* const shape = shapes == nullptr ? nullptr : shapes->find(id);
    Position const* const position = positions == nullptr ? nullptr : positions->find(id);
    Rotation const* const rotation = rotations == nullptr ? nullptr : rotations->find(id);
    if (shape == nullptr || position == nullptr || faultIn(*shape)) {
        return std::nullopt;
    }
    return Placed{shape, Pose(position->value, rotation == nullptr ? 0 : rotation->angle)};
}

double common(ShapePiece const& piece, Pose const& pose, LiquidPiece const& other) {
    std::vector<Vec2> const all = straightened(piece);
    // Two round pieces have more sides than a ClippedPolygon holds; every fifth corner of one is near enough.
    std::size_t const step = all.size() + other.sides.size() > ClippedPolygon::capacity ? 5 : 1;
    std::vector<Vec2> corners;
    for (std::size_t i = 0; i < all.size(); i += step) {
        corners.push_back(pose.toWorld(all[i]));
    }
    ClippedPolygon polygon(corners);
    for (Side const& side : other.sides) {
        polygon.clip(side, 0);
    }
    return polygonMoments(polygon.corners()).area;
}

} // namespace

std::optional<std::string> checkLiquid(Store const& store, ObjectId id) {
    std::optional<Placed> const own = placedLiquid(store, id);
    auto const* const shapes = store.findColumn<Shape>();
    if (shapes == nullptr || !shapes->has(id)) {
        return "it is a liquid without a shape; expected a shape, which is the liquid's area";
    }
    if (!own) {
        return std::nullopt; // whatever is wrong with it is said elsewhere
    }
    std::vector<LiquidPiece> const pieces = liquidPieces(*own->shape, own->pose);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            double const area = common(own->shape->pieces[i], own->pose, pieces[j]);
            if (area > allowedOverlap) {
                return fmt::format("its pieces {} and {} overlap by {:.3g} m²; expected pieces side by side",
                                   j + 1, i + 1, area);
            }
        }
    }
    auto const& liquids = *store.findColumn<Liquid>();
    for (ObjectId const other : liquids.owners()) {
        std::optional<Placed> const placed = other < id ? placedLiquid(store, other) : std::nullopt;
        if (!placed) {
            continue;
        }
        for (ShapePiece const& piece : placed->shape->pieces) {
            for (LiquidPiece const& mine : pieces) {
                double const area = common(piece, placed->pose, mine);
                if (area > allowedOverlap) {
                    return fmt::format(
                        "it overlaps the liquid '{}' by {:.3g} m²; expected liquids side by side",
                        store.nameOf(other), area);
                }
            }
        }
    }
    return std::nullopt;
}

} // namespace trembler
