// Converts our shapes to Chipmunk's.
#ifdef TREMBLER_HAS_CHIPMUNK
#include "physics/dynamics/engines/chipmunk/chipmunk_engine.hpp"

#include <array>

namespace trembler {
namespace {

cpShape* newShape(cpBody& body, ShapePiece const& piece, Vec2 centre) {
    auto const inBody = [&](Vec2 point) {
        Vec2 const v = piece.at + rotated(point, piece.angle) - centre;
        return cpv(v.x, v.y);
    };
    std::array<cpVect, 8> corners;
    switch (piece.form) {
    case ShapeForm::circle:
        return cpCircleShapeNew(&body, piece.radius, inBody({}));
    case ShapeForm::capsule: {
        double const half = piece.width / 2 - piece.radius;
        return cpSegmentShapeNew(&body, inBody({-half, 0}), inBody({half, 0}), piece.radius);
    }
    case ShapeForm::box: {
        double const x = piece.width / 2;
        double const y = piece.height / 2;
        corners = {inBody({-x, -y}), inBody({x, -y}), inBody({x, y}), inBody({-x, y})};
        return cpPolyShapeNewRaw(&body, 4, corners.data(), skin);
    }
    case ShapeForm::polygon:
        for (std::size_t i = 0; i < piece.corners.size(); ++i) {
            corners[i] = inBody(piece.corners[i]);
        }
        return cpPolyShapeNewRaw(&body, static_cast<int>(piece.corners.size()), corners.data(), skin);
    }
    return nullptr;
}

} // namespace

void addShapes(cpSpace& space, cpBody& body, SlotIndex slot, BodySpec const& spec) {
    std::size_t count = 0;
    for (ShapePiece const& piece : spec.shape->pieces) {
        cpShape* const shape = newShape(body, piece, spec.spread.centre);
        // The name is an integer that fits into Chipmunk's user data pointer.
        cpShapeSetUserData(shape, reinterpret_cast<void*>(std::uintptr_t{pieceName(slot, count++)}));
        cpSpaceAddShape(&space, shape);
    }
}

std::uint32_t pieceOf(cpShape const* shape) {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(cpShapeGetUserData(shape)));
}

} // namespace trembler
#endif
