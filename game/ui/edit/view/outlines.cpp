#include "game/ui/edit/view/outlines.hpp"

#include "render/scene/objects/body.hpp"

namespace trembler::ui {

using namespace render;

void outline(Canvas& canvas, std::vector<Point> corners, Stroke const& stroke) {
    if (!corners.empty()) {
        corners.push_back(corners.front());
        canvas.polyline(corners, stroke);
    }
}

void outlineObject(Canvas& canvas, Facts const& facts, Pose const& pose, Stroke const& stroke) {
    if (facts.shape == nullptr) {
        canvas.ring(pose.at, innerSize(facts) + canvas.metres(4), stroke);
        return;
    }
    for (ShapePiece const& piece : facts.shape->pieces) {
        std::vector<Point> corners = outlineOf(piece);
        for (Point& corner : corners) {
            corner = toWorld(pose, corner);
        }
        outline(canvas, corners, stroke);
    }
}

void outlineEntry(Canvas& canvas, EditParts const& parts, FactsReader const& reader, std::string const& name,
                  Stroke const& stroke) {
    for (ObjectId const id : parts.world.objectsOf(name)) {
        if (Facts const facts = reader.of(id); facts.visible()) {
            outlineObject(canvas, facts, poseOf(facts), stroke);
        }
    }
}

} // namespace trembler::ui
