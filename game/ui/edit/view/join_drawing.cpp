#include "game/ui/edit/view/join_drawing.hpp"

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/view/outlines.hpp"
#include "game/ui/shared/words.hpp"
#include "render/panels/world_label.hpp"

namespace trembler::ui {
namespace {

using namespace render;

bool isActive(EditParts const& parts) {
    return (parts.tool == Tool::wire || parts.tool == Tool::joint) && !parts.document.readOnly();
}

} // namespace

void drawJoining(Canvas& canvas, EditParts const& parts, JoinTool const& join) {
    World const* const world = parts.world.world();
    if (!isActive(parts) || world == nullptr) {
        return;
    }
    FactsReader const reader(*world);
    auto const mark = [&](ObjectId object, Stroke const& stroke) {
        Facts const facts = reader.of(object);
        outlineObject(canvas, facts, poseOf(facts), stroke);
    };
    // Between an outline of an object that is as bright and the paper, it must be told from a selection.
    for (ObjectId const object : joinableInView(parts, join.from())) {
        mark(object, {.colour = palette::goal, .pixels = 7, .alpha = 0.3F});
        mark(object, {.colour = palette::goal, .pixels = 2, .alpha = 0.95F});
    }
    if (join.from().valid()) {
        mark(join.from().object, {.colour = palette::accent, .pixels = 3, .alpha = 0.95F});
    }
    if (join.under().valid()) {
        mark(
            join.under().object,
            {.colour = join.why().empty() ? palette::accent : palette::warning, .pixels = 4, .alpha = 0.95F});
    }
    if (!join.from().valid()) {
        return;
    }
    Pointer const& pointer = parts.pointer;
    bool const grid = parts.tool == Tool::joint && !pointer.free;
    Vec2 const to = grid ? parts.snapping.place(pointer.world) : pointer.world;
    canvas.line(
        toPoint(join.start()), toPoint(to),
        {.colour = join.why().empty() ? palette::accent : palette::warning, .pixels = 2.5F, .alpha = 0.9F});
    canvas.circle({toPoint(join.start()), 0}, canvas.metres(5), {.tint = palette::accent});
}

void drawJoiningWords(EditParts const& parts, JoinTool const& join) {
    if (!isActive(parts) || parts.pointer.overCard) {
        return;
    }
    auto const chip = [&](std::string const& text, Colour colour) {
        worldLabel(parts.camera(), toPoint(parts.pointer.world), text.c_str(),
                   {.look = LabelLook::Chip, .colour = colour, .below = 34});
    };
    if (!join.why().empty()) {
        chip(join.why(), palette::warning);
    } else if (join.under().valid() && join.under().object != join.from().object) {
        chip(words::capital(join.under().name), palette::accent);
    } else if (parts.tool == Tool::wire && join.from().valid()) {
        chip(words::wireFromHere, palette::accent);
    } else if (parts.tool == Tool::joint && join.from().valid()) {
        chip(words::jointToWorld, palette::accent);
    } else if (!join.under().valid() && parts.pointer.inside) {
        chip(parts.tool == Tool::wire ? words::wireBegins : words::jointBegins, palette::accent);
    }
}

} // namespace trembler::ui
