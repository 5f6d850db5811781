#include "game/ui/play/field_drawing.hpp"

#include "game/ui/play/lesson/lesson_drawing.hpp"
#include "game/ui/play/whatif/what_if_drawing.hpp"
#include "game/ui/play/why/why_drawing.hpp"
#include "game/ui/shared/scene_words.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/panels/world_label.hpp"
#include "render/scene/objects/part.hpp"

#include <imgui.h>

#include <array>

namespace trembler::ui {
namespace {

using namespace render;

/// The handle that turns the selected part, on its arc.
void drawHandle(PlayParts& parts) {
    auto const handle = parts.handle();
    if (!handle) {
        return;
    }
    auto const& carried = parts.placing.carried();
    Placement const& placement = handle->placement;
    Canvas& canvas = parts.context.canvas;
    Point const centre = toPoint(placement.at);
    double const arm = length(handle->at - placement.at);
    Colour const colour = palette::accent;
    double const angle = handle->angle;
    canvas.arc(centre, arm, angle - 0.5, 0.36, {.colour = colour, .pixels = 2, .alpha = 0.55F});
    canvas.arc(centre, arm, angle + 0.14, 0.36, {.colour = colour, .pixels = 2, .alpha = 0.55F});
    Pointer const& pointer = parts.pointer;
    bool const near =
        length(pointer.world - handle->at) < handleReach * pointer.pixel || (carried && carried->turning);
    canvas.circle(
        {toPoint(handle->at), 0}, canvas.metres(near ? 10 : 8),
        {.tint = near ? palette::accent : palette::paperLight, .outline = 2.4F, .outlineColour = colour});
}

void drawCarried(PlayParts& parts) {
    auto const& carried = parts.placing.carried();
    if (!carried || parts.pointer.overToolbox) {
        return;
    }
    parts.context.canvas.newSheet();
    drawPart(parts.context.canvas, parts.session.parts(), carried->landing,
             {.ghost = true, .forbidden = !carried->verdict.ok});
}

/// The parts that are dragged together, and the box in which parts are being chosen.
void drawGroup(PlayParts& parts) {
    Canvas& canvas = parts.context.canvas;
    if (!parts.group.landings().empty() && !parts.pointer.overToolbox) {
        canvas.newSheet();
    }
    for (PlacedPart const& part : parts.group.landings()) {
        if (!parts.pointer.overToolbox) {
            drawPart(canvas, parts.session.parts(), part.placement,
                     {.ghost = true, .forbidden = !parts.group.verdict().ok});
        }
    }
    if (auto const box = parts.group.box()) {
        Point const a = toPoint(box->first);
        Point const b = toPoint(box->second);
        Point const corners[] = {a, {b.x, a.y}, b, {a.x, b.y}, a};
        canvas.polyline(corners, {.colour = palette::accent, .pixels = 2, .alpha = 0.8F});
    }
}

void drawCross(Canvas& canvas, Point at, Colour colour) {
    double const arm = canvas.metres(15);
    double const gap = canvas.metres(4);
    for (Point const way : {Point{1, 0}, Point{-1, 0}, Point{0, 1}, Point{0, -1}}) {
        canvas.line(at + gap * way, at + arm * way,
                    {.colour = colour, .pixels = 3, .outline = 1, .round = true});
    }
}

/// The pointer that keys move, and that of a second player, in the colour of the second hand.
void drawPointers(PlayParts const& parts) {
    Canvas& canvas = parts.context.canvas;
    if (parts.keyPointer.active()) {
        drawCross(canvas, toPoint(parts.keyPointer.at()), palette::accent);
    }
    if (parts.secondPointer.active()) {
        Point const at = toPoint(parts.secondPointer.at());
        drawCross(canvas, at, palette::secondHand);
        canvas.ring(at, canvas.metres(18), {.colour = palette::secondHand, .pixels = 2.5F});
    }
}

/// The wire that is being laid.
void drawNewWire(PlayParts const& parts) {
    ObjectId const from = parts.wires.from();
    if (!from.valid()) {
        return;
    }
    World const& world = parts.shownWorld();
    FactsReader const reader(world);
    ObjectId const to = parts.wires.to();
    Facts const end = to.valid() ? reader.of(to) : Facts{};
    Pose const there = to.valid() ? parts.scene.poseOf(world, to) : Pose{toPoint(parts.pointer.world), 0};
    auto const path = cablePath(reader.of(from), parts.scene.poseOf(world, from), end, there);
    parts.context.canvas.polyline(path,
                                  {.colour = parts.wires.why().empty() ? palette::accent : palette::warning,
                                   .pixels = 4,
                                   .alpha = 0.8F});
}

/// Marks the wire that a click of the scissors would cut.
void drawBlades(PlayParts const& parts) {
    auto const& wire = parts.run.building() ? parts.wires.wireUnderBlades() : parts.hand.wireUnderBlades();
    if (!(parts.hand.cutting() || parts.wires.cutting()) || !wire.a.valid()) {
        return;
    }
    World const& world = parts.shownWorld();
    FactsReader const reader(world);
    Facts const a = reader.of(wire.a);
    Facts const b = reader.of(wire.b);
    auto const path = cablePath(a, parts.scene.poseOf(world, wire.a), b, parts.scene.poseOf(world, wire.b));
    parts.context.canvas.polyline(path, {.colour = palette::warning, .pixels = 5, .alpha = 0.8F});
}

/// `bare`: only those of the world itself.
void drawWords(PlayParts const& parts, bool bare) {
    World const& world = parts.shownWorld();
    Camera const& camera = parts.camera();
    if (bare) { // Gui::endFrame draws the following before everything else
        ImGui::GetBackgroundDrawList()->AddCallback(ImDrawCallback_ResetRenderState, nullptr);
    }
    drawSceneWords(camera, world, parts.scene, parts.alpha(), parts.shown.names);
    parts.goals.drawWords(camera, bare ? std::span<Placed const>() : parts.context.layout.cards());
    if (bare) {
        return;
    }
    drawWhyWords(camera, static_cast<double>(parts.context.window.uiScale()), parts.why);
    auto const chip = [&](Vec2 at, std::string const& text, Colour colour, float below) {
        worldLabel(camera, toPoint(at), text.c_str(),
                   {.look = LabelLook::Chip, .colour = colour, .below = below});
    };
    if (ObjectId const under = parts.hoverName.object(); world.store().alive(under)) {
        chip(parts.pointer.world, words::capital(shownName(world.store().nameOf(under))), palette::ink, 28);
    }
    auto const& carried = parts.placing.carried();
    if (carried && !carried->verdict.ok && !parts.pointer.overCard) {
        chip(carried->landing.at, translated(carried->verdict.why), palette::warning, 40);
    }
    if (parts.group.dragging() && !parts.group.verdict().ok && !parts.pointer.overCard) {
        chip(parts.pointer.world, translated(parts.group.verdict().why), palette::warning, 40);
    }
    if (carried && carried->turning) {
        auto const degrees = static_cast<int>(std::lround(carried->landing.angle * 180 / pi));
        chip(carried->landing.at, std::to_string(degrees) + "°", palette::accent, 40);
    }
    if (parts.wires.laying() && !parts.pointer.overCard) {
        if (!parts.wires.why().empty()) {
            chip(parts.pointer.world, translated(parts.wires.why()), palette::warning, 28);
        } else if (parts.wires.from().valid() && !parts.wires.to().valid()) {
            chip(parts.pointer.world, words::wireFromHere, palette::accent, 28);
        } else if (!parts.wires.from().valid() && !parts.picking.hovered().valid()) {
            chip(parts.pointer.world, words::wireBegins, palette::accent, 28);
        }
    }
    if (auto const& wire = parts.wires.wireUnderBlades(); parts.wires.cutting() && wire.a.valid()) {
        chip(parts.pointer.world,
             words::putThisBack(world.store().nameOf(wire.a), world.store().nameOf(wire.b)), palette::warning,
             28);
    }
    if (auto const& wire = parts.hand.wireUnderBlades(); parts.hand.cutting() && wire.a.valid()) {
        chip(parts.pointer.world, words::cutThis(world.store().nameOf(wire.a), world.store().nameOf(wire.b)),
             palette::warning, 28);
    }
}

/// Objects that are drawn in another way, beside the one that SceneOptions has room for.
struct Marked {
    std::vector<ObjectId> selected;
    std::vector<ObjectId> hovered;
    std::vector<ObjectId> hidden;

    static void add(std::vector<ObjectId>& to, std::vector<ObjectId> const& more) {
        to.insert(to.end(), more.begin(), more.end());
    }
};

/// All pieces of the parts that are chosen, carried or dragged.
Marked markedObjects(PlayParts const& parts) {
    Marked marked;
    auto const& carried = parts.placing.carried();
    if (carried && carried->number) {
        Marked::add(marked.hidden, parts.session.objectsOf(*carried->number));
    } else if (parts.placing.selected() && !carried) {
        Marked::add(marked.selected, parts.session.objectsOf(*parts.placing.selected()));
    }
    ObjectId const under = parts.picking.hovered();
    if (auto const number = parts.session.numberOf(under);
        under.valid() && number && parts.run.building() && !carried) {
        Marked::add(marked.hovered, parts.session.objectsOf(*number));
    }
    if (ObjectId const chosen = parts.session.world().store().find(parts.whatIfTool->chosen());
        parts.whatIf->atMoment() && chosen.valid()) {
        marked.selected.push_back(chosen);
    }
    Marked::add(marked.selected, objectsOfStep(parts.why, parts.shownWorld()));
    for (int const number : parts.group.chosen()) {
        Marked::add(parts.group.dragging() ? marked.hidden : marked.selected,
                    parts.session.objectsOf(number));
    }
    return marked;
}

SceneOptions sceneOptions(PlayParts& parts, double time) {
    bool const bare = parts.film.wants(parts.run.stepped());
    SceneOptions options{.time = time, .alpha = parts.alpha(), .overlays = parts.shown.overlays()};
    auto const& carried = parts.placing.carried();
    options.goals = parts.goals.regions(parts.timeline.goals());
    if (!parts.timeline.looksBack()) {
        std::array const hands{&parts.hand, &parts.secondHand};
        for (std::size_t i = 0; i < hands.size(); ++i) {
            if (auto const place = hands[i]->pointer()) {
                options.hands[i] = toPoint(*place);
            }
        }
    }
    if (bare) {
        return options;
    }
    if (parts.session.level().placing && parts.run.building()) {
        options.placing = *parts.session.level().placing;
        options.faintPlacing = !(carried && !carried->turning) && !parts.group.dragging();
    }
    if (parts.inspector.open() && !(parts.placing.selected() && !carried)) {
        options.selected = parts.inspector.object(parts.session);
    }
    ObjectId const hovered = parts.picking.hovered();
    bool const canTake =
        parts.run.building() ? parts.session.numberOf(hovered).has_value() : !parts.hand.cutting();
    options.hovered = canTake && !carried ? hovered : ObjectId{};
    return options;
}

} // namespace

void drawField(PlayParts& parts) {
    UiContext& context = parts.context;
    Canvas& canvas = context.canvas;
    World const& world = parts.shownWorld();
    double const shown = static_cast<double>(parts.timeline.frame()) * frameDuration;
    double const time = std::max(shown + (parts.alpha() - 1) * frameDuration, 0.0);
    canvas.begin(parts.camera(), {.uiScale = context.window.uiScale(),
                                  .time = time,
                                  .shadows = context.shadows,
                                  .flattening = parts.squash.flattening(parts.session)});
    canvas.paper();
    bool const past = parts.timeline.looksBack();
    std::vector<render::Ripple> const ripples = past ? parts.timeline.ripples() : parts.sounds.ripples();
    render::SceneOptions options = sceneOptions(parts, time);
    options.ripples = ripples;
    Marked const marked = markedObjects(parts);
    if (!parts.film.wants(parts.run.stepped())) {
        options.alsoSelected = marked.selected;
        options.alsoHovered = marked.hovered;
    }
    options.alsoHidden = marked.hidden;
    std::vector<ObjectId> const flattened = parts.squash.objects(parts.session);
    options.flattened = flattened;
    parts.scene.draw(canvas, world, options);
    canvas.newSheet();
    if (!past) {
        drawSparks(canvas, parts.sparks.sparks());
        parts.cuts.draw(canvas);
    }
    bool const bare = parts.film.wants(parts.run.stepped()); // a picture to be kept has no interface
    if (bare) {
        drawCarried(parts);
        drawGroup(parts);
        canvas.end();
        drawWords(parts, true);
        return;
    }
    drawWhatIf(canvas, world, *parts.whatIf, *parts.whatIfTool, parts.timeline.frame());
    drawWhy(canvas, parts.why);
    drawNewWire(parts);
    drawBlades(parts);
    drawHandle(parts);
    drawLessonGhost(parts);
    drawCarried(parts);
    drawGroup(parts);
    drawPointers(parts);
    canvas.end();
    drawWords(parts, false);
}

} // namespace trembler::ui
