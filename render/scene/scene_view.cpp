#include "render/scene/scene_view.hpp"

#include "render/scene/objects/body.hpp"
#include "render/scene/objects/device.hpp"
#include "render/scene/objects/joints.hpp"
#include "render/scene/overlays/overlay_buoyancy.hpp"
#include "render/scene/overlays/overlay_contacts.hpp"
#include "render/scene/overlays/overlay_electricity.hpp"
#include "render/scene/overlays/overlay_hand.hpp"
#include "render/scene/overlays/overlay_magnetism.hpp"

#include <algorithm>

namespace trembler::render {
namespace {

void drawGround(Canvas& canvas, SceneOptions const& options) {
    for (Area const& area : options.placing) {
        drawPlacingArea(canvas, area, options.faintPlacing);
    }
    for (GoalRegion const& goal : options.goals) {
        drawGoalRegion(canvas, goal);
    }
}

bool isOneOf(std::span<ObjectId const> all, ObjectId id) {
    return std::find(all.begin(), all.end(), id) != all.end();
}

void drawObjects(Canvas& canvas, FactsReader const& reader, PoseOf const& place,
                 SceneOptions const& options) {
    Extent const view = viewOf(canvas.camera()).widened(canvas.metres(20));
    bool moving = false;
    for (Facts const& facts : reader.drawOrder()) {
        Pose const pose = place(facts);
        // The extent of a drawing takes longer to compute, and matters only where the body is out of sight.
        if (!extentOf(facts, pose).widened(deviceGlow(facts).reach).overlaps(view) &&
            (facts.drawing == nullptr || !pictureExtentOf(facts, pose).overlaps(view))) {
            continue;
        }
        if (!moving && !(facts.fixed && facts.shape != nullptr)) {
            canvas.newSheet(); // moving objects cast their shadows on fixed ones
            moving = true;
        }
        if ((facts.id == options.hidden && options.hidden.valid()) || isOneOf(options.alsoHidden, facts.id)) {
            continue;
        }
        canvas.flatten(isOneOf(options.flattened, facts.id));
        drawObject(canvas, facts, pose,
                   {.selected = facts.id == options.selected || isOneOf(options.alsoSelected, facts.id),
                    .hovered = facts.id == options.hovered || isOneOf(options.alsoHovered, facts.id)});
        canvas.flatten(false);
    }
}

// In order from the ground up; another overlay is one more line here.
void drawOverlays(Canvas& canvas, World const& world, FactsReader const& reader,
                  std::vector<Link> const& links, PoseOf const& place, Overlays const& overlays) {
    if (overlays.fieldLines) {
        drawFieldLines(canvas, world);
    }
    if (overlays.electricity) {
        drawElectricity(canvas, reader, links, place);
    }
    if (overlays.contacts) {
        drawContacts(canvas, world);
    }
    if (overlays.forces) {
        drawMagneticForces(canvas, world);
        drawBuoyancy(canvas, world);
    }
}

} // namespace

Pose SceneView::poseOf(World const& world, ObjectId id, double alpha) const {
    return poses_.of(FactsReader(world).of(id), alpha);
}

void SceneView::draw(Canvas& canvas, World const& world, SceneOptions const& options) const {
    FactsReader const reader(world);
    PoseOf const place = [&](Facts const& facts) { return poses_.of(facts, options.alpha); };
    auto const hide = [&](std::vector<Link>& some) {
        std::erase_if(some, [&](Link const& link) {
            return isOneOf(options.alsoHidden, link.a) || isOneOf(options.alsoHidden, link.b);
        });
    };
    std::vector<Link> links = linksOf(world);
    hide(links);
    drawGround(canvas, options);
    canvas.newSheet();
    drawObjects(canvas, reader, place, options);
    canvas.newSheet();
    drawJoints(canvas, world, reader, place, options.alsoHidden);
    std::vector<Link> wires = links;
    addGeneratorLines(world, wires);
    hide(wires);
    drawWires(canvas, reader, wires, place, options.time);
    canvas.newSheet();
    drawOverlays(canvas, world, reader, links, place, options.overlays);
    drawRipples(canvas, options.ripples);
    drawHand(canvas, world, reader, place, options.hands);
}

void drawScene(Canvas& canvas, World const& world, SceneOptions const& options) {
    SceneView().draw(canvas, world, options);
}

} // namespace trembler::render
