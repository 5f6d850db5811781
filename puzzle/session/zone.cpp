#include "puzzle/session/zone.hpp"

#include "physics/box_tree.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shapes/corners.hpp"
#include "runtime/level/build/placed_pieces.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace trembler {
namespace {

constexpr double outlineStep = 0.02; // m
constexpr int mostSteps = 1000;      // of one side
constexpr int arcSteps = 24;         // corners of a whole circle

/// The corners of a piece's outline in the world, m. Round ends have corners on the circle.
std::vector<Vec2> outlineOf(ShapePiece const& piece, PlacedShape const& placed) {
    std::vector<Vec2> corners;
    auto const arc = [&](Vec2 centre, double from, int steps) {
        for (int i = 0; i <= steps; ++i) {
            corners.push_back(centre + rotated({piece.radius, 0}, from + 2 * pi * i / arcSteps));
        }
    };
    switch (piece.form) {
    case ShapeForm::circle:
        arc({}, 0, arcSteps - 1);
        break;
    case ShapeForm::capsule: {
        double const half = std::max(0.0, piece.width / 2 - piece.radius);
        arc({half, 0}, -pi / 2, arcSteps / 2);
        arc({-half, 0}, pi / 2, arcSteps / 2);
        break;
    }
    case ShapeForm::box:
    case ShapeForm::polygon:
        corners = straightCornersOf(piece);
        break;
    }
    for (Vec2& corner : corners) {
        corner = placed.at + rotated(piece.at + rotated(corner, piece.angle), placed.angle);
    }
    return corners;
}

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b) {
    Vec2 const side = b - a;
    double const square = lengthSquared(side);
    double const along = square > 0 ? std::clamp(dot(p - a, side) / square, 0.0, 1.0) : 0;
    return length(p - (a + along * side));
}

/// Whether the point lies in the area or no farther than `allowed` from it.
bool isNear(Area const& area, Vec2 p, double allowed) {
    if (area.contains(p)) {
        return true;
    }
    if (area.box) {
        Vec2 const high = area.box->corner + area.box->size;
        Vec2 const inside{std::clamp(p.x, area.box->corner.x, high.x),
                          std::clamp(p.y, area.box->corner.y, high.y)};
        return length(p - inside) <= allowed;
    }
    for (std::size_t i = 0, j = area.corners.size() - 1; i < area.corners.size(); j = i++) {
        if (distanceToSegment(p, area.corners[j], area.corners[i]) <= allowed) {
            return true;
        }
    }
    return false;
}

/// The areas that any point of the outlines can be near to, so that the many points of an outline are
/// compared with few of a level's areas.
std::vector<Area const*> areasNear(std::span<Area const> areas,
                                   std::vector<std::vector<Vec2>> const& outlines, double allowed) {
    std::vector<Area const*> close;
    if (outlines.empty()) {
        return close;
    }
    Bounds around = boundsOf(outlines.front());
    for (std::vector<Vec2> const& corners : outlines) {
        around.include(boundsOf(corners));
    }
    constexpr double rounding = 1e-6; // m; points between corners are rounded
    Vec2 const more{allowed + rounding, allowed + rounding};
    around = {around.lower - more, around.upper + more};
    for (Area const& area : areas) {
        bool const any = area.box || !area.corners.empty();
        if (any && boundsOf(area).meets(around)) {
            close.push_back(&area);
        }
    }
    return close;
}

} // namespace

Bounds boundsOf(Area const& area) {
    return area.box ? Bounds{area.box->corner, area.box->corner + area.box->size} : boundsOf(area.corners);
}

bool liesWithin(PlacedShape const& placed, std::span<Area const> areas, double allowed) {
    std::vector<std::vector<Vec2>> outlines;
    for (ShapePiece const& piece : placed.shape.pieces) {
        outlines.push_back(outlineOf(piece, placed));
    }
    std::vector<Area const*> const close = areasNear(areas, outlines, allowed);
    auto const inside = [&](Vec2 p) {
        return std::any_of(close.begin(), close.end(),
                           [&](Area const* area) { return isNear(*area, p, allowed); });
    };
    auto const sideInside = [&](Vec2 from, Vec2 to) {
        double const steps = std::ceil(length(to - from) / outlineStep);
        int const count = static_cast<int>(std::clamp(steps, 1.0, static_cast<double>(mostSteps)));
        for (int i = 0; i < count; ++i) {
            if (!inside(from + (to - from) * (static_cast<double>(i) / count))) {
                return false;
            }
        }
        return true;
    };
    for (std::vector<Vec2> const& corners : outlines) {
        for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
            if (!sideInside(corners[j], corners[i])) {
                return false;
            }
        }
    }
    return true;
}

std::optional<std::string> whyItSticksOut(LevelFile const& level, PartLibrary const& parts,
                                          Placement const& placement) {
    if (!level.placing && !level.bounds) {
        return std::nullopt;
    }
    Area const bounds{.box = level.bounds, .corners = {}};
    std::span<Area const> const areas =
        level.placing ? std::span<Area const>(*level.placing) : std::span(&bounds, 1);
    for (PlacedPiece const& piece : placedPieces(parts, placement)) {
        Shape const* const shape = piece.properties.find<Shape>();
        Position const* const position = piece.properties.find<Position>();
        if (shape == nullptr || position == nullptr) {
            continue;
        }
        Rotation const* const rotation = piece.properties.find<Rotation>();
        PlacedShape const placed{*shape, position->value, rotation == nullptr ? 0 : rotation->angle};
        if (!liesWithin(placed, areas, allowedOutside)) {
            return level.placing ? "It would stick out of the area for parts."
                                 : "It would stick out of the level.";
        }
    }
    return std::nullopt;
}

} // namespace trembler
