#include "physics/buoyancy/hulls/exact_hull.hpp"

#include "physics/buoyancy/hulls/disc.hpp"
#include "physics/dynamics/properties/shapes/shape_order.hpp"

#include <algorithm>

namespace trembler {
namespace {

// A factor slightly above 1, so that rounding in the rotation never leaves a corner out.
constexpr double slack = 1 + 1e-9;

std::vector<Vec2> boxCorners(double width, double height, Vec2 at, double angle) {
    Vec2 const w = rotated({width / 2, 0}, angle);
    Vec2 const h = rotated({0, height / 2}, angle);
    return {at - w - h, at + w - h, at + w + h, at - w + h};
}

// Half of the length of a capsule's straight part.
double straightHalf(ShapePiece const& capsule) {
    return capsule.width / 2 - capsule.radius;
}

// The moments of the half disc that lies on the inner side of a line through its centre.
AreaMoments halfDiscMoments(double radius, Vec2 normal) {
    Vec2 const along = perpendicular(normal);
    AreaMoments half = sectorMoments(radius, along, -normal);
    half += sectorMoments(radius, -normal, -along);
    return half;
}

double reachOf(ShapePiece const& piece) {
    switch (piece.form) {
    case ShapeForm::circle:
        return length(piece.at) + piece.radius;
    case ShapeForm::capsule:
        return length(piece.at) + piece.width / 2;
    case ShapeForm::box:
    case ShapeForm::polygon:
        break;
    }
    double reach = 0;
    for (Vec2 const corner : straightened(piece)) {
        reach = std::max(reach, length(corner));
    }
    return reach;
}

} // namespace

ExactHull::ExactHull(Shape const& shape) : Hull(shapeMoments(shape), reachOf(shape)) {
    Shape const ordered = inOrder(shape);
    for (ShapePiece const& piece : ordered.pieces) {
        switch (piece.form) {
        case ShapeForm::circle:
            discs_.push_back({piece.at, piece.radius, std::nullopt});
            break;
        case ShapeForm::box:
        case ShapeForm::polygon:
            polygons_.push_back(straightened(piece));
            break;
        case ShapeForm::capsule: {
            double const half = straightHalf(piece);
            if (half > 0) {
                polygons_.push_back(boxCorners(2 * half, 2 * piece.radius, piece.at, piece.angle));
            }
            for (double const side : {-1.0, 1.0}) {
                Vec2 const outward = rotated({side, 0}, piece.angle);
                Vec2 const centre = piece.at + half * outward;
                discs_.push_back({centre, piece.radius, Side{-outward, -dot(outward, centre)}});
            }
            break;
        }
        }
    }
}

Displacement ExactHull::displaced(std::span<Side const> sides, Vec2 up) const {
    Displacement sum;
    for (std::vector<Vec2> const& corners : polygons_) {
        sum += polygonDisplaced(corners, sides, up);
    }
    for (Disc const& disc : discs_) {
        sum += discDisplaced(disc, sides, up);
    }
    return sum;
}

Displacement ExactHull::polygonDisplaced(std::span<Vec2 const> corners, std::span<Side const> sides,
                                         Vec2 up) {
    ClippedPolygon polygon(corners);
    for (std::size_t i = 0; i < sides.size() && !polygon.empty(); ++i) {
        polygon.clip(sides[i], static_cast<int>(i));
    }
    Displacement result;
    if (polygon.empty()) {
        return result;
    }
    result.wet = polygonMoments(polygon.corners());
    for (std::size_t i = 0; i < polygon.corners().size(); ++i) {
        if (int const tag = polygon.tag(i); tag != ClippedPolygon::own) {
            result.waterline.add(polygon.corners()[i], polygon.after(i),
                                 sides[static_cast<std::size_t>(tag)].normal, up);
        }
    }
    return result;
}

Displacement ExactHull::discDisplaced(Disc const& disc, std::span<Side const> sides, Vec2 up) {
    Side const* cut = nullptr;
    std::size_t cuts = disc.flat ? 1 : 0;
    for (Side const& side : sides) {
        double const distance = side.offset - dot(side.normal, disc.centre);
        if (distance <= -disc.radius) {
            return {};
        }
        if (distance < disc.radius) {
            cut = &side;
            ++cuts;
        }
    }
    if (cut == nullptr) {
        AreaMoments const all =
            disc.flat ? halfDiscMoments(disc.radius, disc.flat->normal) : discMoments(disc.radius);
        return {all.moved(disc.centre), {}};
    }
    if (cuts > 1) {
        return manySided(disc, sides, up);
    }
    Vec2 const n = cut->normal;
    double const distance = cut->offset - dot(n, disc.centre);
    Segment const segment = discSegment(disc.radius, distance);
    Displacement result{segment.moments(n).moved(disc.centre), {}};
    Vec2 const middle = disc.centre + distance * n;
    Vec2 const chord = segment.halfChord * perpendicular(n);
    result.waterline.add(middle - chord, middle + chord, n, up);
    return result;
}

Displacement ExactHull::manySided(Disc const& disc, std::span<Side const> sides, Vec2 up) {
    // The polygon of all sides, within a square that holds the disc.
    ClippedPolygon polygon(boxCorners(2 * slack * disc.radius, 2 * slack * disc.radius, disc.centre, 0));
    if (disc.flat) {
        polygon.clip(*disc.flat, ClippedPolygon::own);
    }
    for (std::size_t i = 0; i < sides.size(); ++i) {
        polygon.clip(sides[i], static_cast<int>(i));
    }
    Displacement result;
    if (polygon.empty()) {
        return result;
    }
    for (std::size_t i = 0; i < polygon.corners().size(); ++i) {
        DiscSide const side =
            discSide(disc.radius, polygon.corners()[i] - disc.centre, polygon.after(i) - disc.centre);
        result.wet += side.moments;
        if (int const tag = polygon.tag(i); side.cuts && tag != ClippedPolygon::own) {
            result.waterline.add(disc.centre + side.chord[0], disc.centre + side.chord[1],
                                 sides[static_cast<std::size_t>(tag)].normal, up);
        }
    }
    result.wet = result.wet.moved(disc.centre);
    return result;
}

AreaMoments shapeMoments(Shape const& shape) {
    AreaMoments sum;
    Shape const ordered = inOrder(shape);
    for (ShapePiece const& piece : ordered.pieces) {
        switch (piece.form) {
        case ShapeForm::circle:
            sum += discMoments(piece.radius).moved(piece.at);
            break;
        case ShapeForm::box:
        case ShapeForm::polygon:
            sum += polygonMoments(straightened(piece));
            break;
        case ShapeForm::capsule: {
            double const half = straightHalf(piece);
            sum += polygonMoments(boxCorners(2 * half, 2 * piece.radius, piece.at, piece.angle));
            for (double const side : {-1.0, 1.0}) {
                Vec2 const outward = rotated({side, 0}, piece.angle);
                sum += halfDiscMoments(piece.radius, -outward).moved(piece.at + half * outward);
            }
            break;
        }
        }
    }
    return sum;
}

double reachOf(Shape const& shape) {
    double reach = 0;
    for (ShapePiece const& piece : shape.pieces) {
        reach = std::max(reach, reachOf(piece));
    }
    return slack * reach;
}

} // namespace trembler
