#include "physics/buoyancy/hulls/hull.hpp"

namespace trembler {

Displacement displacedOf(Hull const& hull, LiquidPiece const& piece, Pose const& pose, Vec2 up) {
    // Most bodies are far from most liquids: these need not even the room for what might cut them.
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
