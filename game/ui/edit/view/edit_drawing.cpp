#include "game/ui/edit/view/edit_drawing.hpp"

#include "game/ui/edit/study/place_map_view.hpp"
#include "game/ui/edit/view/join_drawing.hpp"
#include "game/ui/edit/view/outlines.hpp"
#include "game/ui/shared/scene_words.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "render/panels/world_label.hpp"
#include "render/scene/areas.hpp"
#include "render/scene/objects/body.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace trembler::ui {
namespace {

using namespace render;

constexpr double finestGrid = 9; // pixels between the lines of the grid

void drawGrid(Canvas& canvas, EditParts const& parts) {
    if (!parts.snapping.on) {
        return;
    }
    double step = parts.snapping.grid;
    while (step < finestGrid * canvas.metres(1)) {
        step *= 5;
    }
    Extent const seen = viewOf(parts.camera());
    Stroke const stroke{.colour = palette::grid, .pixels = 1, .alpha = 0.35F};
    for (double x = std::ceil(seen.lower.x / step) * step; x <= seen.upper.x; x += step) {
        canvas.line({x, seen.lower.y}, {x, seen.upper.y}, stroke);
    }
    for (double y = std::ceil(seen.lower.y / step) * step; y <= seen.upper.y; y += step) {
        canvas.line({seen.lower.x, y}, {seen.upper.x, y}, stroke);
    }
}

void drawKnob(Canvas& canvas, Vec2 at, bool round, bool near) {
    Style const style{.tint = near ? palette::accent : palette::paperLight,
                      .outline = 2.F,
                      .outlineColour = palette::accent};
    if (round) {
        canvas.circle({toPoint(at), 0}, canvas.metres(7), style);
    } else {
        double const half = canvas.metres(5);
        canvas.box({toPoint(at), 0}, {half, half}, 0, style);
    }
}

void drawSelection(Canvas& canvas, EditParts const& parts, EditMouse const& mouse) {
    auto const near = [&](Vec2 at) {
        return trembler::length(parts.pointer.world - at) < 12 * parts.pointer.pixel;
    };
    FactsReader const reader(*parts.world.world());
    std::string const& piece = parts.selection.piece();
    for (std::string const& name : parts.selected()) {
        bool const locked = edit::isLocked(parts.tree(), name);
        Stroke const whole{
            .colour = locked ? palette::inkSoft : palette::accent, .pixels = 3, .alpha = 0.95F};
        if (piece.empty()) {
            outlineEntry(canvas, parts, reader, name, whole);
            continue;
        }
        // The objects faintly: they are moved, but the panel is about the piece.
        outlineEntry(canvas, parts, reader, name, {.colour = whole.colour, .pixels = 1.5F, .alpha = 0.45F});
        ObjectId const id = parts.world.world()->store().find(name + " " + piece);
        if (id.valid() && reader.of(id).visible()) {
            outlineObject(canvas, reader.of(id), poseOf(reader.of(id)), whole);
        }
    }
    bool const dragging = mouse.doing() == EditMouse::Doing::moving;
    auto const handles = parts.tool == Tool::select && !dragging ? handlesOf(parts) : std::nullopt;
    if (!handles) {
        return;
    }
    Vec2 const low = handles->box.corner;
    Vec2 const high = low + handles->box.size;
    outline(canvas, {toPoint(low), {high.x, low.y}, toPoint(high), {low.x, high.y}},
            {.colour = palette::accent, .pixels = 1, .alpha = 0.6F});
    canvas.line({handles->middle().x, high.y}, toPoint(handles->turn),
                {.colour = palette::accent, .pixels = 1.5F, .alpha = 0.7F});
    drawKnob(canvas, handles->turn, true, near(handles->turn));
    for (Vec2 const at : handles->scaling) {
        drawKnob(canvas, at, false, near(at));
    }
    for (Vec2 const at : shapeCorners(parts)) { // smaller, as there may be many
        bool const under = trembler::length(parts.pointer.world - at) < 7 * parts.pointer.pixel;
        canvas.circle({toPoint(at), 0}, canvas.metres(4.5),
                      {.tint = under ? palette::accent : palette::paperLight,
                       .outline = 2.F,
                       .outlineColour = palette::goal});
    }
}

void drawAreas(Canvas& canvas, EditParts const& parts) {
    if (parts.level.bounds) {
        outline(canvas, outlineOf(Area{parts.level.bounds, {}}),
                {.colour = palette::inkSoft, .pixels = 1.5F, .alpha = 0.5F});
    }
    for (SceneArea const& area : sceneAreas(parts)) {
        Colour const colour = area.kind == EntryKind::placing ? palette::accent : palette::goal;
        outline(canvas, outlineOf(area.area),
                {.colour = colour, .pixels = area.selected ? 3.F : 1.5F, .alpha = 0.8F});
        if (area.selected) {
            for (Vec2 const corner : areaCorners(area.area)) {
                drawKnob(canvas, corner, false,
                         trembler::length(parts.pointer.world - corner) < 12 * parts.pointer.pixel);
            }
        }
    }
}

void drawLinks(Canvas& canvas, EditParts const& parts) {
    if (parts.selection.kind() == EntryKind::connection) {
        for (edit::ConnectionEntry const& link : edit::connectionsOf(parts.tree())) {
            if (link.index == indexOfPath(parts.selection.path())) {
                canvas.polyline(pathOf(parts, link.a, link.b),
                                {.colour = palette::accent, .pixels = 6, .alpha = 0.7F});
            }
        }
    }
    for (JointPoint const& point : jointPoints(parts)) {
        bool const selected =
            parts.selection.kind() == EntryKind::joint && point.joint == indexOfPath(parts.selection.path());
        canvas.ring(toPoint(point.at), canvas.metres(selected ? 9 : 6),
                    {.colour = selected ? palette::accent : palette::force,
                     .pixels = selected ? 3.F : 2.F,
                     .alpha = 0.9F});
    }
}

/// The object that would be made if the button were released now.
void drawPreview(Canvas& canvas, EditParts& parts, EditMouse const& mouse) {
    using Doing = EditMouse::Doing;
    Stroke const stroke{.colour = palette::accent, .pixels = 2.5F, .alpha = 0.9F};
    Vec2 const from = mouse.start();
    Vec2 const at = parts.pointer.world;
    Vec2 const to = parts.pointer.free || mouse.doing() == Doing::boxing ? at : parts.snapping.place(at);
    std::vector<Point> const box{toPoint(from), {to.x, from.y}, toPoint(to), {from.x, to.y}};
    if (mouse.doing() == Doing::boxing) {
        outline(canvas, box, {.colour = palette::accent, .pixels = 1.5F, .alpha = 0.8F});
    } else if (mouse.doing() == Doing::drawing) {
        if (parts.tool == Tool::disc) {
            canvas.ring(toPoint(from), trembler::length(to - from), stroke);
        } else if (parts.tool == Tool::capsule) {
            canvas.capsule(toPoint(from), toPoint(to), parts.capsuleRadius,
                           {.tint = palette::accent, .alpha = 0.4F});
        } else {
            outline(canvas, box, stroke);
        }
    }
    if (!mouse.corners().empty()) {
        std::vector<Point> corners;
        for (Vec2 const corner : mouse.corners()) {
            corners.push_back(toPoint(corner));
        }
        corners.push_back(toPoint(to));
        canvas.polyline(corners, stroke);
        drawKnob(canvas, mouse.corners().front(), true,
                 trembler::length(at - mouse.corners().front()) < 12 * parts.pointer.pixel);
    }
    if (!parts.partInHand.empty() && !parts.pointer.overCard) {
        if (Prototype const* const part = parts.catalog().prototype(parts.partInHand)) {
            canvas.newSheet();
            drawGhost(canvas, *part, {toPoint(to), 0}, true);
        }
    }
}

/// Numbers beside a dragged object.
void drawNumbers(EditParts const& parts, EditMouse const& mouse) {
    using Doing = EditMouse::Doing;
    if (mouse.doing() == Doing::nothing || mouse.doing() == Doing::pressing ||
        mouse.doing() == Doing::boxing || mouse.doing() == Doing::connecting) {
        return;
    }
    std::array<char, 80> text{};
    Vec2 const at = parts.pointer.free ? parts.pointer.world : parts.snapping.place(parts.pointer.world);
    if (mouse.doing() == Doing::drawing) {
        std::snprintf(text.data(), text.size(), "%.3g × %.3g m", std::abs(at.x - mouse.start().x),
                      std::abs(at.y - mouse.start().y));
    } else {
        Vec2 const place = mouse.doing() == Doing::moving ? mouse.movedTo() : at;
        std::snprintf(text.data(), text.size(), "%.3f, %.3f m", place.x, place.y);
    }
    std::string const shown = mouse.refused().empty() ? std::string(text.data()) : mouse.refused();
    worldLabel(parts.camera(), toPoint(parts.pointer.world), shown.c_str(),
               {.look = LabelLook::Chip,
                .colour = mouse.refused().empty() ? palette::accent : palette::warning,
                .below = 34});
}

} // namespace

void drawEditedScene(EditParts& parts, EditMouse const& mouse) {
    UiContext& context = parts.context;
    Canvas& canvas = context.canvas;
    canvas.begin(parts.camera(),
                 {.uiScale = context.window.uiScale(), .time = 0, .shadows = context.shadows});
    canvas.paper();
    drawGrid(canvas, parts);
    World const* const world = parts.world.world();
    std::vector<Area> placing; // not of the level, which is read after a drag
    std::vector<GoalRegion> goals;
    for (SceneArea const& area : sceneAreas(parts)) {
        if (area.kind == EntryKind::goalArea) {
            goals.push_back({area.area, false});
        } else {
            placing.push_back(area.area);
        }
    }
    if (world != nullptr) {
        SceneOptions options{.placing = placing, .goals = goals};
        options.overlays.electricity = parts.electricity;
        bool const picks = parts.tool == Tool::select && mouse.doing() == EditMouse::Doing::nothing;
        options.hovered = picks ? world->store().find(mouse.hovered()) : ObjectId{};
        parts.scene.draw(canvas, *world, options);
    }
    canvas.newSheet();
    drawAreas(canvas, parts);
    if (world != nullptr) {
        drawLinks(canvas, parts);
        drawPlaceMap(parts, canvas);
        drawSelection(canvas, parts, mouse);
        drawJoining(canvas, parts, mouse.join());
        drawPreview(canvas, parts, mouse);
    }
    canvas.end();
    if (world != nullptr) {
        drawSceneWords(parts.camera(), *world, parts.scene, 1, parts.names);
    }
    drawNumbers(parts, mouse);
    drawJoiningWords(parts, mouse.join());
}

} // namespace trembler::ui
