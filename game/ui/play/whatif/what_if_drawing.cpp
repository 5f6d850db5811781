#include "game/ui/play/whatif/what_if_drawing.hpp"

#include "game/ui/play/whatif/what_if_colour.hpp"
#include "insight/whatif/pieces.hpp"
#include "render/scene/facts/pick.hpp"
#include "render/scene/objects/body.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using namespace render;

/// The object in its own material, half transparent, with a rim in the colour of the other run.
void drawGhostOf(Canvas& canvas, Facts const& facts, Pose const& pose) {
    if (!facts.visible()) {
        return;
    }
    drawObject(canvas, facts, pose, {.ghost = true});
    if (facts.shape == nullptr) {
        canvas.ring(pose.at, symbolRadius, {.colour = whatIfColour(), .pixels = 2.5F});
        return;
    }
    for (ShapePiece const& piece : facts.shape->pieces) {
        std::vector<Point> rim = outlineOf(piece);
        for (Point& point : rim) {
            point = toWorld(pose, point);
        }
        if (!rim.empty()) {
            rim.push_back(rim.front());
            canvas.polyline(rim, {.colour = whatIfColour(), .pixels = 2.5F});
        }
    }
}

/// A cross over objects that no longer exist in the other run.
void drawGone(Canvas& canvas, Facts const& facts) {
    Extent const extent = extentOf(facts, poseOf(facts));
    if (extent.empty()) {
        return;
    }
    double const arm = std::min({extent.half().x, extent.half().y, canvas.metres(26)});
    Point const at = extent.centre();
    for (double const way : {1.0, -1.0}) {
        canvas.line({at.x - arm, at.y - way * arm}, {at.x + arm, at.y + way * arm},
                    {.colour = whatIfColour(), .pixels = 4, .round = true});
    }
}

/// Dots where nothing is yet, a line where it has been.
void drawPath(Canvas& canvas, insight::OtherPath const& path, std::uint64_t frame) {
    std::vector<Point> past;
    std::vector<Point> later;
    for (insight::OtherPath::At const& each : path.points) {
        (each.frame <= frame ? past : later).push_back(toPoint(each.at));
    }
    if (past.size() > 1) {
        canvas.polyline(past, {.colour = whatIfColour(), .pixels = 2, .alpha = 0.75F});
    }
    for (std::size_t i = 0; i < later.size(); i += 2) {
        canvas.circle({later[i], 0}, canvas.metres(1.6), {.tint = whatIfColour()});
    }
}

void drawDrag(Canvas& canvas, World const& world, WhatIfTool::Drag const& drag) {
    ObjectId const object = world.store().find(drag.object);
    FactsReader const reader(world);
    if (drag.pull) {
        if (drag.moved) {
            canvas.arrow(toPoint(drag.from), toPoint(drag.at + drag.grip),
                         {.colour = whatIfColour(), .pixels = 3});
        }
        return;
    }
    Facts const held = reader.of(object);
    if (held.position == nullptr) {
        return;
    }
    double const turn = drag.angle - (held.rotation == nullptr ? 0 : held.rotation->angle);
    for (ObjectId const piece : insight::piecesWith(world.store(), object)) {
        Facts const facts = reader.of(piece);
        if (facts.position != nullptr) {
            Vec2 const arm = rotated(facts.position->value - held.position->value, turn);
            drawGhostOf(canvas, facts, {toPoint(drag.at + arm), poseOf(facts).angle + turn});
        }
    }
}

} // namespace

void drawWhatIf(Canvas& canvas, World const& real, WhatIfView& view, WhatIfTool const& tool,
                std::uint64_t frame) {
    if (!view.active()) {
        return;
    }
    if (insight::OtherRun const* const run = view.run()) {
        for (auto const& [object, path] : run->paths()) {
            drawPath(canvas, path, frame);
        }
    }
    World const* const other = view.world();
    if (other != nullptr) {
        FactsReader const reader(*other);
        for (Facts const& facts : reader.drawOrder()) {
            if (insight::isElsewhere(real.store(), other->store(), facts.id)) {
                drawGhostOf(canvas, facts, poseOf(facts));
            }
        }
        for (Facts const& facts : FactsReader(real).drawOrder()) {
            if (!other->store().alive(facts.id)) {
                drawGone(canvas, facts);
            }
        }
    }
    World const& shown = other != nullptr ? *other : real;
    if (tool.drag() && tool.drag()->moved) {
        drawDrag(canvas, shown, *tool.drag());
    }
    if (render::Link const& wire = tool.wireUnderBlades(); tool.cutting() && wire.a.valid()) {
        FactsReader const reader(shown);
        Facts const a = reader.of(wire.a);
        Facts const b = reader.of(wire.b);
        canvas.polyline(cablePath(a, poseOf(a), b, poseOf(b)),
                        {.colour = palette::warning, .pixels = 5, .alpha = 0.8F});
    }
}

} // namespace trembler::ui
