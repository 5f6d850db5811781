#include "render/scene/scene_view.hpp"

#include "render/scene/body.hpp"

namespace trembler::render {

void SceneView::start(World const&) {
    poses_.forget();
}

void SceneView::remember(World const& world) {
    poses_.remember(world);
}

Pose SceneView::poseOf(World const& world, ObjectId id, double alpha) const {
    return poses_.of(FactsReader(world).of(id), alpha);
}

void SceneView::draw(Canvas& canvas, World const& world, SceneOptions const& options) const {
    FactsReader const reader(world);
    auto const place = [&](Facts const& facts) { return poses_.of(facts, options.alpha); };
    bool moving = false;
    for (Facts const& facts : reader.drawOrder()) {
        if (!moving && !(facts.fixed && facts.shape != nullptr)) {
            canvas.newSheet(); // what moves throws its shadow on what does not
            moving = true;
        }
        drawObject(canvas, facts, place(facts),
                   {.selected = facts.id == options.selected && facts.id.valid(),
                    .hovered = facts.id == options.hovered && facts.id.valid()});
    }
    canvas.newSheet();
    drawWires(canvas, reader, linksOf(world), place, options.time);
}

void drawScene(Canvas& canvas, World const& world, SceneOptions const& options) {
    SceneView().draw(canvas, world, options);
}

} // namespace trembler::render
