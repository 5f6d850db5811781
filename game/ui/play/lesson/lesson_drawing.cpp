#include "game/ui/play/lesson/lesson_drawing.hpp"

#include "game/ui/shared/commands/named_keys.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"
#include "render/scene/objects/part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::ui {
namespace {

using namespace render;
using Taught = TeachingStep::Kind;

constexpr double cycle = 3; // s, of the hand's way

ImVec2 pixelsOf(Point at) {
    return {static_cast<float>(at.x), static_cast<float>(at.y)};
}

float smooth(double t) {
    auto const x = static_cast<float>(std::clamp(t, 0.0, 1.0));
    return x * x * (3 - 2 * x);
}

/// A pointing hand whose finger tip is at `tip`; `pressed`: the finger is down.
void drawPointingHand(ImDrawList& list, ImVec2 tip, float alpha, bool pressed) {
    float const size = scaled(pressed ? 0.9F : 1.F);
    // Rounded bars in the hand's frame: x, y, width, height, pixels below and beside the tip.
    struct Bar {
        float x, y, width, height;
    };
    constexpr Bar bars[] = {{-4, 0, 9, 30},                                        // the index finger
                            {5, 14, 8, 16},                                        // the others, folded
                            {12.5F, 16, 8, 15}, {20, 18, 7, 13}, {-5, 22, 32, 22}, // the palm
                            {-13, 21, 13, 9}};                                     // the thumb
    auto const fill = [&](float grow, Colour colour) {
        for (Bar const& bar : bars) {
            list.AddRectFilled(
                {tip.x + size * bar.x - grow, tip.y + size * bar.y - grow},
                {tip.x + size * (bar.x + bar.width) + grow, tip.y + size * (bar.y + bar.height) + grow},
                imColour(faded(colour, alpha)), size * 5 + grow);
        }
    };
    fill(scaled(2), palette::ink);
    fill(0, palette::paperLight);
    Colour const line = mix(palette::paperShade, palette::ink, 0.5F);
    for (float const x : {5.F, 12.5F, 20.F}) {
        list.AddLine({tip.x + size * x, tip.y + size * 20}, {tip.x + size * x, tip.y + size * 29},
                     imColour(faded(line, alpha)), scaled(1.2F));
    }
    if (pressed) {
        list.AddCircle(tip, scaled(11), imColour(faded(palette::accent, alpha)), 0, scaled(2.5F));
    }
}

/// A ring around something on a card that is to be pressed.
void drawRing(ImDrawList& list, Rect const& rect, double age, bool moves) {
    float const wave = moves ? 0.5F + 0.5F * std::sin(static_cast<float>(5 * age)) : 0.5F;
    float const gap = scaled(3 + 3 * wave);
    ImVec2 const low = pixelsOf(rect.low);
    ImVec2 const high = pixelsOf(rect.high);
    list.AddRect({low.x - gap, low.y - gap}, {high.x + gap, high.y + gap}, imColour(palette::accent),
                 scaled(11), 0, scaled(3.5F));
}

/// A note's edge around its words.
ImVec2 noteEdge() {
    return {scaled(11), scaled(7)};
}

/// The place of a note with these words; `at` is the middle of its lower edge. Moved so that it lies on the
/// screen.
Rect notePlace(ImVec2 at, std::string const& words) {
    ImFont* const font = theme().fonts.strong;
    ImVec2 const size = font->CalcTextSizeA(font->FontSize, 1e9F, 0, words.c_str());
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    auto const [x, y] = noteEdge();
    ImVec2 low{at.x - 0.5F * size.x - x, at.y - size.y - 2 * y};
    low.x = std::clamp(low.x, scaled(6), std::max(screen.x - size.x - 2 * x - scaled(6), scaled(6)));
    low.y = std::clamp(low.y, scaled(6), std::max(screen.y - size.y - 2 * y - scaled(6), scaled(6)));
    return {{low.x, low.y}, {low.x + size.x + 2 * x, low.y + size.y + 2 * y}};
}

/// Whether a card is there whose words the player reads, other than that of the button to press.
bool hidesWords(PlayParts const& parts, Rect const& note, std::optional<Rect> const& ring) {
    constexpr std::array<std::string_view, 9> read{"why",        "hints", "inspector", "goal",   "success",
                                                   "components", "mods",  "probes",    "what if"};
    std::vector<Placed> const& cards = parts.context.layout.cards();
    return std::any_of(cards.begin(), cards.end(), [&](Placed const& card) {
        bool const pressed = ring && card.rect.contains(ring->middle());
        return !pressed && note.overlaps(card.rect) &&
               std::find(read.begin(), read.end(), card.name) != read.end();
    });
}

void drawNote(ImDrawList& list, Rect const& place, std::string const& words) {
    ImFont* const font = theme().fonts.strong;
    ImVec2 const low = pixelsOf(place.low);
    auto const [x, y] = noteEdge();
    list.AddRectFilled(low, pixelsOf(place.high), imColour(palette::accent), scaled(9));
    list.AddText(font, font->FontSize, {low.x + x, low.y + y}, imColour(palette::paperLight), words.c_str());
}

/// The hand on its way, or, at rest, at its end with a dotted line behind it.
void drawWay(ImDrawList& list, ImVec2 from, ImVec2 to, double age, bool moves) {
    auto const between = [&](float t) {
        return ImVec2{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
    };
    float const far = std::hypot(to.x - from.x, to.y - from.y);
    int const dots = std::clamp(static_cast<int>(far / scaled(14)), 1, 200);
    for (int i = 1; i < dots; ++i) {
        list.AddCircleFilled(between(static_cast<float>(i) / static_cast<float>(dots)), scaled(2.4F),
                             imColour(faded(palette::accent, 0.55F)));
    }
    if (!moves) {
        return drawPointingHand(list, to, 1, true);
    }
    double const t = std::fmod(age, cycle);
    bool const pressed = t > 0.5 && t < 2.2;
    auto const fades = static_cast<float>(std::min({t / 0.3, (cycle - 0.2 - t) / 0.4, 1.0}));
    if (fades > 0) {
        drawPointingHand(list, between(smooth((t - 0.7) / 1.3)), fades, pressed);
    }
}

/// The key of a command that the device has, as shown to the player.
std::string keysFor(PlayParts const& parts, std::string_view command) {
    return keyOfDevice(command, keyDevice(parts.lesson.device()), parts.context.keys);
}

/// The keys that move things.
std::string arrowsFor(PlayParts const& parts) {
    return namedDirections(keyDevice(parts.lesson.device()), parts.context.keys);
}

/// Where an object is on the screen; nothing if it is not in the world.
std::optional<ImVec2> screenOf(PlayParts const& parts, std::string const& name) {
    World const& world = parts.session.world();
    ObjectId const object = world.store().find(name);
    if (!object.valid()) {
        return std::nullopt;
    }
    return pixelsOf(parts.camera().toScreen(parts.scene.poseOf(world, object, parts.run.alpha()).at));
}

/// The drawing of a step: where it begins and ends on the screen, the button or key to press, and words.
struct LessonShown {
    std::optional<ImVec2> from;
    std::optional<ImVec2> to;
    std::optional<Rect> ring;
    std::string words;
};

/// Where a button was in the last picture.
std::optional<Rect> itemPlace(PlayParts const& parts, std::string_view name) {
    Layout const& layout = parts.context.layout;
    return layout.item(name);
}

bool isCarried(PlayParts const& parts, std::string const& part) {
    auto const& carried = parts.placing.carried();
    return carried && carried->landing.part == part;
}

LessonShown shownPlace(PlayParts const& parts, TeachingStep const& step) {
    LessonShown shown;
    shown.to = pixelsOf(parts.camera().toScreen({step.at.x, step.at.y}));
    bool const mouse = parts.lesson.device() == InputDevice::mouse;
    bool const carried = isCarried(parts, step.object);
    std::optional<ImVec2> elsewhere;
    bool selected = false; // and the keys move it, not the pointer
    if (!carried) {
        shown.ring = itemPlace(parts, "part " + step.object);
        if (shown.ring) {
            shown.from = pixelsOf(shown.ring->middle());
        }
        for (PlacedPart const& part : parts.session.placed()) { // it lies elsewhere
            if (part.placement.part == step.object) {
                shown.ring.reset();
                elsewhere = pixelsOf(parts.camera().toScreen({part.placement.at.x, part.placement.at.y}));
                shown.from = elsewhere;
                selected = parts.placing.selected() == part.number && !parts.keyPointer.active();
            }
        }
    }
    if (mouse) {
        shown.words = text("lesson.drag");
    } else if (carried) {
        shown.words = textWith("lesson.move_by_keys", arrowsFor(parts), keysFor(parts, "act"));
    } else if (elsewhere && selected) {
        shown.words = textWith("lesson.nudge_by_keys", arrowsFor(parts));
    } else if (elsewhere) {
        shown.to = elsewhere; // beside what is to be taken
        shown.words = textWith("lesson.fetch_by_keys", arrowsFor(parts), keysFor(parts, "act"));
    } else {
        shown.words = textWith("lesson.take_by_key", keysFor(parts, "next-part"));
    }
    return shown;
}

LessonShown shownPress(PlayParts const& parts, char const* command, char const* byMouse) {
    LessonShown shown;
    std::string item(command);
    std::replace(item.begin(), item.end(), '-', ' ');
    shown.ring = itemPlace(parts, item);
    if (shown.ring) {
        shown.to = pixelsOf(shown.ring->middle());
    }
    std::string const key = keysFor(parts, command);
    bool const mouse = parts.lesson.device() == InputDevice::mouse || key.empty();
    shown.words = mouse ? byMouse : textWith("lesson.press_key", key);
    return shown;
}

LessonShown shownOf(PlayParts const& parts, TeachingStep const& step) {
    LessonShown shown;
    bool const mouse = parts.lesson.device() == InputDevice::mouse;
    switch (step.kind) {
    case Taught::place:
        return shownPlace(parts, step);
    case Taught::run:
        return shownPress(parts, "run", text("lesson.run"));
    case Taught::wire:
        if (!parts.wires.laying()) {
            return shownPress(parts, "wire", text("lesson.take_wire"));
        }
        shown.from = screenOf(parts, step.object);
        shown.to = screenOf(parts, step.other);
        shown.words = text("lesson.lay");
        return shown;
    case Taught::grab:
        shown.from = screenOf(parts, step.object);
        shown.to = pixelsOf(parts.camera().toScreen({step.at.x, step.at.y}));
        shown.words = mouse ? text("lesson.drag")
                            : textWith("lesson.hold_by_keys", arrowsFor(parts), keysFor(parts, "act"));
        return shown;
    case Taught::cut:
        if (!parts.hand.cutting()) {
            return shownPress(parts, "cut", text("lesson.take_scissors"));
        }
        if (auto const a = screenOf(parts, step.object), b = screenOf(parts, step.other); a && b) {
            shown.to = ImVec2{0.5F * (a->x + b->x), 0.5F * (a->y + b->y)};
        }
        shown.words = text("lesson.cut");
        return shown;
    }
    return shown;
}

} // namespace

void drawLessonGhost(PlayParts& parts) {
    TeachingStep const* const step = parts.lesson.step();
    if (step == nullptr || step->kind != Taught::place) {
        return;
    }
    Placement placement{step->object, step->at, step->angle, {}, step->flipped};
    parts.context.canvas.newSheet();
    drawPart(parts.context.canvas, parts.session.parts(), placement, {.ghost = true});
}

void drawLesson(PlayParts& parts) {
    TeachingStep const* const step = parts.lesson.step();
    if (step == nullptr) {
        return;
    }
    LessonShown const shown = shownOf(parts, *step);
    bool const moves = parts.lesson.moving() && !parts.context.profile.settings().reducedMotion;
    double const age = parts.lesson.age();
    auto& list = *ImGui::GetForegroundDrawList();
    if (shown.ring) {
        drawRing(list, *shown.ring, age, moves);
    }
    if (!shown.to) {
        return;
    }
    bool const mouse = parts.lesson.device() == InputDevice::mouse;
    bool const busy = parts.pointer.held; // the player's own hand is at it
    ImVec2 note{shown.to->x, shown.to->y - scaled(34)};
    if (step->kind == Taught::run && shown.ring) {
        note.y = static_cast<float>(shown.ring->low.y) - scaled(14);
    }
    if (mouse && !busy) {
        if (shown.from) {
            drawWay(list, *shown.from, *shown.to, age, moves);
        } else if (moves && !parts.placing.carried()) {
            bool const down = std::fmod(age, 1.2) > 0.8;
            drawPointingHand(list, *shown.to, 1, down);
        } else if (!parts.placing.carried()) {
            drawPointingHand(list, *shown.to, 1, false);
        }
    }
    Rect place = notePlace(note, shown.words);
    if (hidesWords(parts, place, shown.ring)) {
        auto const height = static_cast<float>(place.high.y - place.low.y);
        place = notePlace({shown.to->x, shown.to->y + scaled(34) + height}, shown.words);
        if (hidesWords(parts, place, shown.ring)) {
            return;
        }
    }
    drawNote(list, place, shown.words);
}

} // namespace trembler::ui
