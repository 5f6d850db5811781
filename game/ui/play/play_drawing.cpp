// What the play screen draws: the world, what lies over it, and the cards around it.
#include "game/ui/play/play_screen.hpp"
#include "game/ui/shared/scene_words.hpp"
#include "game/ui/shared/words.hpp"
#include "render/panels/world_label.hpp"
#include "render/scene/objects/body.hpp"

namespace trembler::ui {

using namespace render;

namespace {

/// How far from a part's own edge its turning handle stands, pixels at UI scale 1.
constexpr double handleGap = 26;

} // namespace

void PlayScreen::drawCards() {
    Layout& layout = context_.layout;
    auto const& carried = placing_.carried();
    state_.carrying = carried && !carried->turning;
    state_.carriedPart = carried ? carried->landing.part : std::string();
    state_.cutting = hand_.cutting();
    state_.components = components_.open();
    state_.goalsShort = components_.open();
    std::optional<Command> asked;
    auto const note = [&](std::optional<Command> command) { asked = command ? command : asked; };
    note(drawGoalCard(layout, session_, state_));
    note(drawCorner(layout));
    if (building() && !inspector_.open()) {
        if (auto const part = drawToolbox(layout, session_, context_.catalog, state_)) {
            bool const same = carried && !carried->number && carried->landing.part == *part;
            if (same) {
                placing_.cancel(); // a second click on its tile puts it back
            } else {
                placing_.take(*part, pointer_);
            }
            takenNow_ = true;
            leftOnPaper_ = false;
        }
    }
    note(drawTransport(layout, session_, state_));
    note(drawTools(layout, session_, state_));
    note(drawSuccess(layout, session_, state_));
    float const scale = context_.window.uiScale();
    float const screen = static_cast<float>(context_.window.size().height) / scale;
    inspector_.draw(layout, session_.world(), cornerRow, screen - cornerRow - bottomRow - 8);
    float top = 150;
    for (char const* above : {"goal", "success"}) {
        if (auto const card = layout.card(above)) {
            top = std::max(top, static_cast<float>(card->high.y) / scale + cardGap);
        }
    }
    budget_.watch(components_.open());
    if (components_.open() && budget_.stale(session_.world())) {
        budget_.look(session_.world());
    }
    components_.draw(layout, session_, budget_, context_.toasts, top, screen - top - bottomRow - 8);
    if (asked) {
        carryOut(*asked);
    }
}

std::optional<Vec2> PlayScreen::handle() const {
    if (!building() || !placing_.selected()) {
        return {};
    }
    auto const& carried = placing_.carried();
    if (carried && !carried->turning) {
        return {};
    }
    Placement const* const placement =
        carried ? &carried->landing : placing_.placementOf(*placing_.selected());
    if (placement == nullptr) {
        return {};
    }
    double const arm = context_.catalog.radius(placement->part) + handleGap * pointer_.pixel;
    return placement->at + rotated({0, arm}, placement->angle);
}

double PlayScreen::alpha() const {
    return session_.mode() == SessionMode::running && !state_.recording ? clock_.alpha() : 1;
}

void PlayScreen::draw() {
    Canvas& canvas = context_.canvas;
    World const& world = session_.world();
    double const time = std::max(world.time() + (alpha() - 1) * frameDuration, 0.0);
    canvas.begin(camera(), {.uiScale = context_.window.uiScale(), .time = time, .shadows = context_.shadows});
    canvas.paper();
    SceneOptions options{.time = time, .alpha = alpha(), .overlays = overlays()};
    auto const& carried = placing_.carried();
    if (session_.level().placing && carried && !carried->turning) {
        options.placing = *session_.level().placing;
    }
    if (placing_.selected() && !carried) {
        options.selected = session_.objectOf(*placing_.selected());
    } else if (inspector_.open()) {
        options.selected = world.store().find(inspector_.name());
    }
    bool const canTake = building() ? session_.numberOf(hovered_).has_value() : !hand_.cutting();
    options.hovered = canTake && !carried ? hovered_ : ObjectId{};
    options.hidden = carried && carried->number ? session_.objectOf(*carried->number) : ObjectId{};
    options.goals = goals_.regions(session_.judge().status());
    std::vector<Ripple> const ripples = sounds_.ripples();
    options.ripples = ripples;
    scene_.draw(canvas, world, options);
    canvas.newSheet();
    drawBlades();
    drawSelection();
    drawGhost();
    canvas.end();
    drawLabels();
}

Overlays PlayScreen::overlays() const {
    return {.electricity = state_.electricity,
            .forces = state_.magnetism,
            .fieldLines = state_.magnetism,
            .contacts = state_.contacts};
}

void PlayScreen::drawSelection() const {
    auto const knob = handle();
    if (!knob) {
        return;
    }
    auto const& carried = placing_.carried();
    Placement const* const placement =
        carried ? &carried->landing : placing_.placementOf(*placing_.selected());
    Canvas& canvas = context_.canvas;
    Point const centre = toPoint(placement->at);
    Point const at = toPoint(*knob);
    double const arm = length(*knob - placement->at);
    Colour const colour = palette::accent;
    double const angle = placement->angle + pi / 2;
    canvas.arc(centre, arm, angle - 0.5, 0.36, {.colour = colour, .pixels = 2, .alpha = 0.55F});
    canvas.arc(centre, arm, angle + 0.14, 0.36, {.colour = colour, .pixels = 2, .alpha = 0.55F});
    bool const near = length(pointer_.world - *knob) < 13 * pointer_.pixel || (carried && carried->turning);
    canvas.circle(
        {at, 0}, canvas.metres(near ? 10 : 8),
        {.tint = near ? palette::accent : palette::paperLight, .outline = 2.4F, .outlineColour = colour});
}

void PlayScreen::drawGhost() const {
    auto const& carried = placing_.carried();
    if (!carried || pointer_.overToolbox) {
        return;
    }
    if (Prototype const* const part = context_.catalog.prototype(carried->landing.part)) {
        context_.canvas.newSheet();
        render::drawGhost(context_.canvas, *part, {toPoint(carried->landing.at), carried->landing.angle},
                          carried->verdict.ok);
    }
}

void PlayScreen::drawBlades() const {
    Canvas& canvas = context_.canvas;
    if (auto const& wire = hand_.wireUnderBlades(); hand_.cutting() && wire.a.valid()) {
        FactsReader const reader(session_.world());
        Facts const a = reader.of(wire.a);
        Facts const b = reader.of(wire.b);
        auto const path =
            cablePath(a, scene_.poseOf(session_.world(), wire.a), b, scene_.poseOf(session_.world(), wire.b));
        canvas.polyline(path, {.colour = palette::warning, .pixels = 5, .alpha = 0.8F});
    }
}

void PlayScreen::drawLabels() const {
    World const& world = session_.world();
    drawSceneWords(camera(), world, scene_, alpha(), state_.names);
    goals_.drawWords(camera());
    auto const& carried = placing_.carried();
    if (carried && !carried->verdict.ok && !pointer_.overCard) {
        worldLabel(camera(), toPoint(carried->landing.at), carried->verdict.why.c_str(),
                   {.look = LabelLook::Chip, .colour = palette::warning, .below = 40});
    }
    if (carried && carried->turning) {
        auto const degrees = static_cast<int>(std::lround(carried->landing.angle * 180 / pi));
        worldLabel(camera(), toPoint(carried->landing.at), (std::to_string(degrees) + "°").c_str(),
                   {.look = LabelLook::Chip, .colour = palette::accent, .below = 40});
    }
    if (auto const& wire = hand_.wireUnderBlades(); hand_.cutting() && wire.a.valid()) {
        worldLabel(camera(), toPoint(pointer_.world),
                   words::cutThis(world.store().nameOf(wire.a), world.store().nameOf(wire.b)).c_str(),
                   {.look = LabelLook::Chip, .colour = palette::warning, .below = 28});
    }
}

} // namespace trembler::ui
