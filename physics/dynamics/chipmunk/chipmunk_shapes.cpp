// Our shapes in Chipmunk's terms, and how it is made to start without a word.
#ifdef TREMBLER_HAS_CHIPMUNK
#include "physics/dynamics/chipmunk/chipmunk_engine.hpp"

#include <array>
#include <cstdio>
#include <mutex>
#include <unistd.h>

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
        // Names fit where Chipmunk has room for a pointer.
        cpShapeSetUserData(shape, reinterpret_cast<void*>(std::uintptr_t{pieceName(slot, count++)}));
        cpSpaceAddShape(&space, shape);
    }
}

std::uint32_t pieceOf(cpShape const* shape) {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(cpShapeGetUserData(shape)));
}

cpSpace* newSpaceQuietly() {
    // Debian's library says on the standard output that it has its checks on, at the first space of a
    // process. What programs write there may be read by others: it goes to the standard error stream.
    static std::once_flag greeted;
    std::call_once(greeted, [] {
        std::fflush(stdout);
        int const output = dup(STDOUT_FILENO);
        if (output >= 0 && dup2(STDERR_FILENO, STDOUT_FILENO) >= 0) {
            cpSpaceFree(cpSpaceNew());
            std::fflush(stdout);
            dup2(output, STDOUT_FILENO);
        }
        if (output >= 0) {
            close(output);
        }
    });
    return cpSpaceNew();
}

} // namespace trembler
#endif
