#include "physics/buoyancy/rules/liquid_rules.hpp"

#include "physics/buoyancy/hulls/liquid_area.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/moments.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {
namespace {

// Smaller overlaps come from rounded numbers in the level file.
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
    // Two round pieces have more sides than a ClippedPolygon holds; every fifth corner of one is exact
    // enough.
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

/// All pieces of all placed liquids, numbered in order of objects.
class Pieces {
public:
    explicit Pieces(Store const& store) : store_(store) {
        std::vector<Bounds> boxes;
        for (ObjectId const id : store.findColumn<Liquid>()->owners()) {
            std::optional<Placed> const placed = placedLiquid(store, id);
            if (!placed) {
                continue;
            }
            liquids_.push_back({id, *placed, static_cast<std::uint32_t>(boxes.size())});
            for (ShapePiece const& piece : placed->shape->pieces) {
                std::vector<Vec2> corners = straightened(piece);
                for (Vec2& corner : corners) {
                    corner = placed->pose.toWorld(corner);
                }
                boxes.push_back(boundsOf(corners));
                ofPiece_.push_back(static_cast<std::uint32_t>(liquids_.size() - 1));
            }
        }
        boxes_ = boxes;
        tree_ = BoxTree(std::move(boxes));
    }

    /// The fault of the liquid, or nothing.
    [[nodiscard]] std::optional<std::string> faultOf(ObjectId id) const {
        auto const found =
            std::lower_bound(liquids_.begin(), liquids_.end(), id,
                             [](PlacedLiquid const& one, ObjectId wanted) { return one.id < wanted; });
        if (found == liquids_.end() || found->id != id) {
            return std::nullopt; // another rule reports its fault
        }
        std::vector<LiquidPiece> const pieces = liquidPieces(*found->placed.shape, found->placed.pose);
        std::optional<std::string> fault = betweenPieces(*found, pieces);
        return fault ? fault : faultWithOtherLiquids(*found, pieces);
    }

private:
    struct PlacedLiquid {
        ObjectId id;
        Placed placed;
        std::uint32_t first; // number of its first piece
    };

    [[nodiscard]] std::optional<std::string> betweenPieces(PlacedLiquid const& liquid,
                                                           std::vector<LiquidPiece> const& pieces) const {
        for (std::uint32_t i = 0; i < pieces.size(); ++i) {
            double area = 0;
            std::uint32_t const number = liquid.first + i;
            auto const overlaps = [&](std::uint32_t other) {
                area =
                    common(liquid.placed.shape->pieces[i], liquid.placed.pose, pieces[other - liquid.first]);
                return area > allowedOverlap;
            };
            if (auto const other = tree_.findFirst(boxes_[number], liquid.first, number, overlaps)) {
                return fmt::format("its pieces {} and {} overlap by {:.3g} m²; expected pieces side by side",
                                   *other - liquid.first + 1, i + 1, area);
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<std::string>
    faultWithOtherLiquids(PlacedLiquid const& liquid, std::vector<LiquidPiece> const& pieces) const {
        std::uint32_t before = liquid.first; // lowest number of a piece that it overlaps
        double first = 0;                    // m², of that overlap
        for (std::uint32_t i = 0; i < pieces.size(); ++i) {
            double area = 0;
            auto const overlaps = [&](std::uint32_t number) {
                PlacedLiquid const& other = liquids_[ofPiece_[number]];
                area = common(other.placed.shape->pieces[number - other.first], other.placed.pose, pieces[i]);
                return area > allowedOverlap;
            };
            if (auto const found = tree_.findFirst(boxes_[liquid.first + i], 0, before, overlaps)) {
                before = *found;
                first = area;
            }
        }
        if (before == liquid.first) {
            return std::nullopt;
        }
        return fmt::format("it overlaps the liquid '{}' by {:.3g} m²; expected liquids side by side",
                           store_.nameOf(liquids_[ofPiece_[before]].id), first);
    }

    Store const& store_;
    std::vector<PlacedLiquid> liquids_;  // ascending
    std::vector<std::uint32_t> ofPiece_; // the liquid that a piece belongs to
    std::vector<Bounds> boxes_;
    BoxTree tree_;
};

} // namespace

std::vector<ObjectFault> checkLiquids(Store const& store) {
    std::vector<ObjectFault> faults;
    auto const* const liquids = store.findColumn<Liquid>();
    auto const* const shapes = store.findColumn<Shape>();
    if (liquids == nullptr || liquids->size() == 0) {
        return faults;
    }
    Pieces const pieces(store);
    for (ObjectId const id : liquids->owners()) {
        if (shapes == nullptr || !shapes->has(id)) {
            faults.push_back(
                {id, "it is a liquid without a shape; expected a shape, which is the liquid's area"});
        } else if (auto fault = pieces.faultOf(id)) {
            faults.push_back({id, std::move(*fault)});
        }
    }
    return faults;
}

} // namespace trembler
