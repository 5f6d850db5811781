#include "game/ui/play/all_cards.hpp"

#include "game/ui/cards/overlay_legend.hpp"
#include "game/ui/cards/play_cards.hpp"
#include "game/ui/play/commands/command_sections.hpp"
#include "game/ui/play/timeline/probe_panel.hpp"
#include "game/ui/play/timeline/timeline_bar.hpp"
#include "game/ui/play/view/level_extents.hpp"
#include "game/ui/play/whatif/what_if_card.hpp"
#include "game/ui/play/whatif/what_if_lane.hpp"
#include "game/ui/play/why/why_drawing.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"
#include "render/scene/areas.hpp"
#include "render/scene/facts/shape_geometry.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace trembler::ui {
namespace {

// Pixels at UI scale 1.
constexpr float panelsWidth = 620;
constexpr float leastForGoalAndPanel = 600; ///< height of the window
constexpr float goalShare = 0.36F;          ///< of the window's height, that the goals may have

void takeFromToolbox(PlayParts& parts, std::string const& part) {
    auto const& carried = parts.placing.carried();
    if (carried && !carried->number && carried->landing.part == part) {
        parts.placing.cancel(); // a second click on its tile puts it back
    } else {
        parts.placing.take(part, parts.pointer);
    }
    parts.mouse.tookPart();
}

std::string keyOf(KeyBindings const& bindings, std::string_view command) {
    auto const keys = bindings.keysOf(command);
    return keys.empty() ? std::string() : labelOf(keys.front());
}

/// Which cards there is room for at the same time.
struct Beside {
    bool goal = true;
    bool toolbox = true;
    bool panels = true; ///< of components or of mods, if one is open
    bool success = false;
    bool hints = false;
    bool narrow = false;   ///< the window
    float right = cardGap; ///< of the inspector and of the card that says why, see SidePlace
};

/// Whether the card of plots or of what-if is open.
bool worksOnPast(PlayParts const& parts) {
    return parts.timeline.shown() && (parts.timeline.probes().choosing() || parts.whatIf->active());
}

/// Whether the inspector would lie over the very object that it is about.
bool coversItsObject(PlayParts const& parts, float width, float right) {
    World const& world = parts.session.world();
    ObjectId const object = parts.inspector.object(parts.session);
    if (!object.valid()) {
        return false;
    }
    auto const scale = static_cast<double>(parts.context.window.uiScale());
    double const x = parts.camera().toScreen(parts.scene.poseOf(world, object).at).x / scale;
    double const edge = static_cast<double>(width - right);
    return x < edge && x > edge - static_cast<double>(inspectorWidth);
}

/// Whether the inspector has opened at the left. `mayBeLeft`: there is room now.
bool inspectorAtLeft(PlayParts& parts, bool mayBeLeft, float width, float right) {
    InspectorSide& side = parts.inspectorSide;
    render::Size const window = parts.context.window.size();
    if (side.of != parts.inspector.subject() || side.window != window) {
        side = {parts.inspector.subject(), window, mayBeLeft && coversItsObject(parts, width, right)};
    }
    return side.left;
}

/// How much of what the answer is about a card at `card` hides, square pixels: objects, and gaps with some
/// room around them, in which the player has to do something.
double hiddenBy(PlayParts const& parts, std::vector<ObjectId> const& objects, Rect const& card) {
    constexpr double room = 20; // pixels at UI scale 1
    double const around = room * static_cast<double>(parts.context.window.uiScale());
    double sum = 0;
    auto const add = [&](render::Extent const& extent, double wider) {
        Rect const rect = onScreen(parts.camera(), extent);
        double const width =
            std::min(rect.high.x + wider, card.high.x) - std::max(rect.low.x - wider, card.low.x);
        double const height =
            std::min(rect.high.y + wider, card.high.y) - std::max(rect.low.y - wider, card.low.y);
        sum += std::max(width, 0.0) * std::max(height, 0.0);
    };
    World const& world = parts.session.world();
    for (ObjectId const object : objects) {
        if (Shape const* const shape = world.find<Shape>(object)) {
            add(render::extentOf(*shape, parts.scene.poseOf(world, object)), 0);
        }
    }
    for (render::Extent const& gap : gapsOfMiss(parts.why)) {
        add(gap, around);
    }
    return sum;
}

/// Whether the card that says why stands at the left: there it hides less of what it explains.
bool whyAtLeft(PlayParts& parts, bool mayBeLeft, float width, float right) {
    WhySide& side = parts.whySide;
    std::optional<Rect> const shown = parts.context.layout.card("why");
    std::vector<ObjectId> of =
        mayBeLeft && shown ? objectsOfStep(parts.why, parts.shownWorld()) : std::vector<ObjectId>();
    render::Size const window = parts.context.window.size();
    double const top = of.empty() ? 0 : shown->low.y;
    double const bottom = of.empty() ? 0 : shown->high.y;
    bool const same = side.of == of && side.window == window && side.top == top && side.bottom == bottom;
    if (!same) {
        bool const left = side.left && !of.empty();
        side = {std::move(of), window, top, bottom, left, false};
    } else if (!side.chosen) {
        auto const scale = static_cast<double>(parts.context.window.uiScale());
        auto const at = [&](float left) {
            double const low = scale * static_cast<double>(left);
            return Rect{{low, top}, {low + scale * static_cast<double>(inspectorWidth), bottom}};
        };
        side.left = !of.empty() && hiddenBy(parts, of, at(cardGap)) <
                                       hiddenBy(parts, of, at(width - right - inspectorWidth));
        side.chosen = true;
    }
    return side.left;
}

/// In a small window a panel takes the place of the goal or the toolbox, and is hidden behind cards that the
/// player must see or has opened later. The toolbox keeps its place while something is built: what is
/// inspected or explained stands beside it.
Beside cardsBeside(PlayParts& parts) {
    render::Window const& window = parts.context.window;
    float const width = static_cast<float>(window.size().width) / window.uiScale();
    float const height = static_cast<float>(window.size().height) / window.uiScale();
    bool const panel = parts.components.open() || (parts.hasMods() && parts.modsPanel.open());
    bool const building = parts.run.building();
    LevelFile const& level = parts.session.level();
    bool const boxed = building && (!level.toolbox.empty() || level.wires > 0);
    float const box = boxed ? toolboxWidth(width, hasLargeToolbox(parts.session)) + cardGap : 0;
    bool const inspects = parts.inspector.open() || parts.why.open(); // one in the place of the other
    Beside beside;
    beside.narrow = width < roomyWidth;
    beside.success = parts.celebration.showing() && !inspects; // the player has asked for that since
    bool const besidePanel = width >= panelsWidth + inspectorWidth + box + 3 * cardGap;
    beside.panels = panel && (besidePanel || !(inspects || beside.success));
    beside.goal = !beside.panels || height >= leastForGoalAndPanel;
    beside.toolbox = building && (!beside.panels || width >= panelsWidth + box + 2 * cardGap);
    beside.right = beside.toolbox ? cardGap + box : cardGap;
    bool const leftIsFree = !beside.panels && !worksOnPast(parts);
    bool const why = whyAtLeft(parts, building && leftIsFree && parts.why.open(), width, beside.right);
    bool const inspector =
        inspectorAtLeft(parts, building && leftIsFree && !parts.why.open(), width, beside.right) &&
        !parts.why.open();
    bool const left = (why || inspector) && leftIsFree;
    beside.right = left ? width - cardGap - inspectorWidth : beside.right;
    bool const holds = parts.placing.carried() || parts.group.dragging();
    float const roomForHints = 2 * cardGap + goalCardWidth + (inspects ? inspectorWidth + beside.right : 0);
    beside.hints = building && parts.hintsShown > 0 && !parts.hintsFolded && !holds && beside.goal &&
                   !parts.goalAside && !beside.panels && !left && width >= roomForHints;
    return beside;
}

/// Below the goals, or, without them, below the row of buttons; pixels at UI scale 1.
float belowGoal(PlayParts const& parts, bool shown) {
    auto const card = parts.context.layout.card("goal");
    if (!shown || !card) {
        return cornerRow;
    }
    return std::max(static_cast<float>(card->high.y) / parts.context.window.uiScale() + cardGap, cornerRow);
}

/// The components panel or that of mods, between the cards at the top of the screen and the row of tools.
void drawPanels(PlayParts& parts, float screen, float bottom, Beside const& beside) {
    UiContext& context = parts.context;
    float const top = belowGoal(parts, beside.goal);
    parts.budget.watch(parts.components.open());
    if (parts.components.open() && parts.budget.stale(parts.session.world())) {
        parts.budget.look(parts.session.world());
    }
    std::string const less = keyOf(context.keys, "less-budget");
    std::string const more = keyOf(context.keys, "more-budget");
    bool const keys = !less.empty() && !more.empty();
    parts.components.setTips({withKey(words::budgetTip, "budget", context.keys),
                              words::lessOrMore + (keys ? " (" + less + ", " + more + ")" : std::string())});
    parts.components.draw(context.layout, parts.session, parts.budget, context.toasts, top,
                          screen - top - bottom - 8);
    if (!parts.hasMods() || parts.why.working() || parts.whatIf->active()) {
        return; // scripts may not be changed while other worlds run them
    }
    World const* const world = &parts.session.world();
    parts.modsPanel.draw(context.layout, parts.data->registry, *parts.liveMods, parts.session, top,
                         screen - top - bottom - 8);
    if (&parts.session.world() != world) { // built again, as the player has changed a script
        parts.newWorld();
    }
}

/// While a clip is being recorded: how long it is.
void drawRecording(PlayParts const& parts) {
    if (!parts.film.recording()) {
        return;
    }
    using namespace render;
    std::string const words = textWith("clip.goes_on", parts.film.seconds());
    ImFont* const font = theme().fonts.strong;
    ImVec2 const size = font->CalcTextSizeA(font->FontSize, 1e9F, 0, words.c_str());
    float const left = 0.5F * (ImGui::GetIO().DisplaySize.x - size.x);
    float const top = ImGui::GetIO().DisplaySize.y - scaled(bottomRow + 36); // toasts are at the top
    auto& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({left - scaled(30), top - scaled(6)},
                       {left + size.x + scaled(12), top + size.y + scaled(6)},
                       imColour(faded(palette::paperLight, 0.95F)), scaled(9));
    list.AddCircleFilled({left - scaled(15), top + 0.5F * size.y}, scaled(6), imColour(palette::warning));
    list.AddText(font, font->FontSize, {left, top}, imColour(palette::ink), words.c_str());
}

void savePlot(PlayParts& parts, std::string const& ending) {
    UiContext& context = parts.context;
    ProbePanel const& probes = parts.timeline.probes();
    std::string const content = ending == ".csv" ? probes.csv() : probes.svg(parts.timeline.last());
    context.pending.write(
        Owned::plot,
        [&recorder = context.recorder, ending, content] {
            return textWith("Saved: {}", shownPath(recorder.write("plot", ending, content)));
        },
        content.size());
}

/// The timeline, the plots above it, and the card in which they are chosen.
void drawPast(PlayParts& parts, CommandButtons& buttons, float bottom) {
    Timeline& timeline = parts.timeline;
    if (!timeline.shown()) {
        return;
    }
    ProbePanel& probes = timeline.probes();
    Layout& layout = parts.context.layout;
    auto const request = drawTimelineBar(buttons, timeline);
    auto wanted = request.frame;
    if (request.why) {
        parts.inspector.close();
        parts.why.askMark(*request.why);
    }
    if (parts.whatIf->active()) {
        auto const pointed = drawWhatIfLane(buttons, timeline, *parts.whatIf);
        wanted = pointed ? pointed : wanted;
    }
    if (!probes.probes().watches().empty()) {
        float const above = bottomRow + timelineRow + timeline.lane();
        auto const pointed = probes.draw(layout, above, timeline.frame(), timeline.last());
        wanted = pointed ? pointed : wanted;
    }
    if (wanted) {
        parts.lookAtPast();
        timeline.seek(*wanted);
    }
    bool const panel = parts.components.open() || parts.modsPanel.open(); // in the same place
    if (probes.choosing() && !panel) {
        ObjectId const object = parts.inspector.object(parts.session);
        std::string const name =
            object.valid() ? parts.session.world().store().nameOf(object) : std::string();
        if (auto const ending = probes.drawChoice(layout, parts.shownWorld(), name, bottom + 8);
            !ending.empty()) {
            savePlot(parts, ending);
        }
    } else if (parts.whatIf->active() && !panel) {
        drawWhatIfCard(buttons, parts.session, *parts.whatIf, *parts.whatIfTool, bottom + 8);
    }
}

/// Whether the goal card lies where a part that is held now may be placed. Once hidden it stays so until the
/// part is let go.
bool goalInTheWay(PlayParts const& parts) {
    auto const& carried = parts.placing.carried();
    if (!(carried && !carried->turning) && !parts.group.dragging()) {
        return false;
    }
    auto const card = parts.context.layout.card("goal");
    auto const& places = parts.session.level().placing;
    return parts.goalAside ||
           (card && places && std::any_of(places->begin(), places->end(), [&](Area const& area) {
                return card->overlaps(onScreen(parts.camera(), render::extentOf(area)));
            }));
}

std::optional<CarriedPart> carriedPart(PlayParts const& parts) {
    auto const& carried = parts.placing.carried();
    if (!carried || carried->turning) { // a part that turns stays where it is
        return {};
    }
    return CarriedPart{carried->landing.part, !carried->number};
}

SuccessLook successLook(PlayParts const& parts) {
    SuccessLook look{.moving = !parts.context.profile.settings().reducedMotion};
    if (!parts.celebration.showing()) {
        return look;
    }
    AfterLevel const after = afterThis(parts);
    look.last = after == AfterLevel::end;
    if (after == AfterLevel::gallery) {
        look.next = text("success.gallery");
    } else if (after == AfterLevel::levels) {
        look.next = text("success.levels");
    } else if (after == AfterLevel::editor) {
        look.next = text("success.editor");
    }
    return look;
}

/// The words of the button for hints; nullptr: there are none, or it runs.
char const* hintLabel(PlayParts const& parts) {
    std::size_t const total = parts.said.hints().size();
    if (total == 0 || !parts.run.building()) {
        return nullptr;
    }
    if (parts.hintsShown == 0 || parts.hintsFolded || parts.hintsHidden) {
        return words::hint;
    }
    return parts.hintsShown < total ? words::nextHint : words::foldHints;
}

void drawGoals(PlayParts& parts, CommandButtons& buttons) {
    render::Window const& window = parts.context.window;
    float const width = static_cast<float>(window.size().width) / window.uiScale();
    float const height = static_cast<float>(window.size().height) / window.uiScale();
    bool const panel = parts.components.open() || parts.modsPanel.open();
    // While it runs the card covers as little as possible.
    GoalCardAsked const asked = drawGoalCard(parts.context.layout, parts.session,
                                             {.said = &parts.said,
                                              .width = goalStripWidth(width, parts.besideCorner),
                                              .most = goalShare * height,
                                              .brief = panel || !parts.run.building(),
                                              .task = parts.ofGallery,
                                              .counts = parts.goalCounts,
                                              .goals = parts.timeline.goals(),
                                              .why = parts.why.canAsk(),
                                              .storyOpen = parts.storyOpen,
                                              .hint = panel ? nullptr : hintLabel(parts)},
                                             &buttons);
    if (asked.why) {
        parts.inspector.close();
        parts.why.askGoal(*asked.why);
    }
    parts.storyOpen = asked.storyOpen ? asked.storyOpen : parts.storyOpen;
}

void drawHints(PlayParts& parts) {
    std::vector<std::string> const& all = parts.said.hints();
    std::size_t const shown = std::min(parts.hintsShown, all.size());
    if (shown == 0) {
        return;
    }
    float const scale = parts.context.window.uiScale();
    float const top = belowGoal(parts, true);
    float const height = static_cast<float>(parts.context.window.size().height) / scale;
    HintCardAsked const asked = drawHintCard(parts.context.layout, {.hints = std::span(all).first(shown),
                                                                    .total = all.size(),
                                                                    .at = std::min(parts.hintAt, shown - 1),
                                                                    .top = top,
                                                                    .most = height - top - bottomRow});
    parts.hintAt = asked.at.value_or(parts.hintAt);
    parts.hintsFolded = asked.fold;
}

} // namespace

std::optional<std::size_t> drawPlayCards(PlayParts& parts, CommandSet const& commands) {
    UiContext& context = parts.context;
    parts.said.follow();
    Layout& layout = context.layout;
    Session const& session = parts.session;
    CommandButtons buttons(layout, context.keys, commands);
    parts.hintsFolded = parts.hintsFolded || !parts.run.building();
    parts.goalAside = goalInTheWay(parts);
    Beside const beside = cardsBeside(parts);
    bool const choosing = worksOnPast(parts);
    bool const goal =
        beside.goal && !parts.goalAside && !(choosing && beside.narrow); // the card of plots takes its room
    parts.hintsHidden = parts.run.building() && parts.hintsShown > 0 && !parts.hintsFolded &&
                        !parts.placing.carried() && !parts.group.dragging() && !(beside.hints && goal);
    if (goal) {
        drawGoals(parts, buttons);
    }
    if (beside.hints && goal) {
        drawHints(parts);
    }
    drawCorner(buttons, !parts.run.building());
    if (beside.toolbox) {
        std::string const hint =
            words::toolboxHint(keyOf(context.keys, "turn-left"), keyOf(context.keys, "turn-right"));
        if (auto const part = drawToolbox(buttons, session, parts.catalog(), parts.toolbox,
                                          {.carried = carriedPart(parts),
                                           .hint = hint,
                                           .allBack = parts.allBack,
                                           .laying = parts.wires.laying(),
                                           .escape = context.input.keyPressed(SDLK_ESCAPE)})) {
            takeFromToolbox(parts, *part);
        }
        if (parts.toolbox.takeWanted()) {
            if (auto const found = parts.toolbox.firstShown(session.toolbox(), parts.catalog())) {
                parts.takeByKey(*found);
            }
        }
    }
    Speed const& speed = parts.run.speed();
    drawTransport(
        buttons,
        {.building = parts.run.building(), .speed = speed.now(), .late = speed.onlyReached().has_value()});
    drawTools(buttons, session, parts.hasMods());
    float const bottom = bottomRow + (parts.timeline.shown() ? parts.timeline.height() : 0);
    drawPast(parts, buttons, bottom);
    if (!beside.panels && !choosing) { // they are in its place
        drawOverlayLegend(layout, parts.shown, bottom - bottomRow);
    }
    if (beside.success || !parts.celebration.showing()) {
        drawSuccess(buttons, session, parts.celebration, successLook(parts));
    }
    float const screen = static_cast<float>(context.window.size().height) / context.window.uiScale();
    if (!beside.success) { // which lies there
        float const top = beside.toolbox ? belowGoal(parts, goal) : cornerRow;
        SidePlace const place{.right = beside.right, .top = top, .height = screen - top - bottom - 8};
        if (parts.inspector.open()) {
            parts.why.close(); // the player has chosen an object since
        }
        if (auto const wanted = parts.why.draw(layout, place)) {
            parts.lookAt(*wanted);
        }
        bool const mayAsk = !parts.run.building() && parts.why.canAsk();
        std::string const whyTip = withKey(words::whyObjectTip, "why", context.keys);
        if (parts.inspector.draw(layout, session, place,
                                 parts.timeline.looksBack() ? &parts.shownWorld() : nullptr,
                                 mayAsk ? whyTip.c_str() : nullptr)) {
            parts.why.askObject(parts.inspector.name(), parts.timeline.frame());
            parts.inspector.close(); // the answer comes in its place
        }
    }
    if (beside.panels) {
        drawPanels(parts, screen, bottom, beside);
    }
    drawRecording(parts);
    return buttons.asked();
}

} // namespace trembler::ui
