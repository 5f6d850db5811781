#include "physics/buoyancy/hulls/hull.hpp"

namespace trembler {

Displacement displacedOf(Hull const& hull, LiquidPiece const& piece, Pose const& pose, Vec2 up) {
    // Most bodies are far from most liquids; for these the list of cutting sides is not made.
    for (Side const& side : piece.sides) {
        if (dot(side.normal, pose.at) - side.offset >= hull.radius()) {
            return {};
        }
    }
    CuttingSides cutting;
    findCuttingSides(piece, pose, hull.radius(), cutting);
    if (cutting.dry) {
        return {};
    }
    if (cutting.count == 0) {
        return {hull.whole(), {}};
    }
    return hull.displaced(std::span(cutting.sides).first(cutting.count), pose.turnedBack(up));
}

} // namespace trembler
