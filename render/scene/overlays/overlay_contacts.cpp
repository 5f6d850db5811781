#include "render/scene/overlays/overlay_contacts.hpp"

#include "physics/dynamics/properties/contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trembler::render {
namespace {

/// A corner of one edge and the point of the other that is nearest to it.
struct Approach {
    Point at; ///< in the middle of the two
    double distance = 0;
    double least = 0; ///< m, how far from the first point a second one must be
};

void approach(std::vector<Approach>& all, std::span<Point const> corners, std::span<Point const> edge,
              double leastApart) {
    for (Point const corner : corners) {
        Approach best{{}, std::numeric_limits<double>::infinity(), leastApart};
        for (std::size_t i = 0; i < edge.size(); ++i) {
            Point const from = edge[i];
            Point const along = edge[(i + 1) % edge.size()] - from;
            double const t =
                std::clamp(dot(corner - from, along) / std::max(dot(along, along), 1e-300), 0.0, 1.0);
            Point const near = from + t * along;
            if (length(corner - near) < best.distance) {
                best = {0.5 * (corner + near), length(corner - near), leastApart};
            }
        }
        all.push_back(best);
    }
}

// A round piece touches in one point, although its outline is drawn with corners.
double leastApart(ShapePiece const& piece) {
    switch (piece.form) {
    case ShapeForm::circle:
        return std::numeric_limits<double>::infinity();
    case ShapeForm::capsule:
        return piece.radius;
    case ShapeForm::box:
    case ShapeForm::polygon:
        return 0.02;
    }
    return 0;
}

std::vector<Point> placedOutline(ShapePiece const& piece, Pose const& pose) {
    std::vector<Point> outline = outlineOf(piece);
    for (Point& corner : outline) {
        corner = toWorld(pose, corner);
    }
    return outline;
}

void mark(Canvas& canvas, Point at) {
    double const size = canvas.metres(5.5);
    std::array const diamond{Point{-size, 0}, Point{0, -size}, Point{size, 0}, Point{0, size}};
    canvas.polygon(
        {at, 0}, diamond,
        {.tint = palette::contact, .outline = 1.4F, .outlineColour = palette::paperLight, .height = 0.F});
}

void drawPatch(Canvas& canvas, ContactPatch const& patch) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::clamp(patch.count, 0, 2)); ++i) {
        Point const at = toPoint(patch.points[i]);
        double const impulse = std::max(0.0, patch.normalImpulse[i]);
        double const reach = contactArrowLength(impulse, canvas.metres(contactArrowUnit));
        canvas.arrow(at, at + reach * toPoint(patch.normal), {.colour = palette::contact, .pixels = 2.6F});
        mark(canvas, at);
    }
}

} // namespace

double contactArrowLength(double impulse, double unit) {
    return unit * (1 + std::log10(1 + 100 * std::max(0.0, impulse)));
}

std::vector<Point> touchingPoints(Shape const& a, Pose const& poseA, Shape const& b, Pose const& poseB) {
    constexpr double near = 0.005;
    std::vector<Approach> all;
    for (ShapePiece const& pieceA : a.pieces) {
        Extent const around = extentOf(pieceA, poseA).widened(0.1);
        for (ShapePiece const& pieceB : b.pieces) {
            if (around.overlaps(extentOf(pieceB, poseB))) {
                std::vector<Point> const outlineA = placedOutline(pieceA, poseA);
                std::vector<Point> const outlineB = placedOutline(pieceB, poseB);
                double const apart = std::max(leastApart(pieceA), leastApart(pieceB));
                approach(all, outlineA, outlineB, apart);
                approach(all, outlineB, outlineA, apart);
            }
        }
    }
    if (all.empty()) {
        return {};
    }
    auto const closer = [](Approach const& x, Approach const& y) { return x.distance < y.distance; };
    Approach const first = *std::min_element(all.begin(), all.end(), closer);
    auto const reach = [&](Approach const& one) {
        double const apart = length(one.at - first.at);
        return one.distance <= first.distance + near && apart > one.least ? apart : 0.0;
    };
    Approach const second = *std::max_element(
        all.begin(), all.end(), [&](Approach const& x, Approach const& y) { return reach(x) < reach(y); });
    return reach(second) > 0 ? std::vector{first.at, second.at} : std::vector{first.at};
}

void drawContacts(Canvas& canvas, World const& world) {
    // Patches that no component or subscription asks for may be old.
    if (auto const* const slot = world.store().findSlot<ContactPatches>();
        slot != nullptr && slot->readers() > 0) {
        for (ContactPatch const& patch : slot->value().patches) {
            drawPatch(canvas, patch);
        }
        return;
    }
    auto const* const contacts = world.find<Contacts>();
    if (contacts == nullptr) {
        return;
    }
    for (TouchingPair const& pair : contacts->current) {
        Shape const* const a = world.find<Shape>(pair.a);
        Shape const* const b = world.find<Shape>(pair.b);
        if (a != nullptr && b != nullptr) {
            for (Point const at : touchingPoints(*a, poseOf(world, pair.a), *b, poseOf(world, pair.b))) {
                mark(canvas, at);
            }
        }
    }
}

} // namespace trembler::render
