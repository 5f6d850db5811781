#include "game/ui/play/all_cards.hpp"

#include "game/ui/cards/overlay_legend.hpp"
#include "game/ui/cards/play_cards.hpp"
#include "game/ui/play/commands/command_sections.hpp"
#include "game/ui/play/timeline/probe_panel.hpp"
#include "game/ui/play/timeline/timeline_bar.hpp"
#include "game/ui/play/view/level_extents.hpp"
#include "game/ui/play/whatif/what_if_card.hpp"
#include "game/ui/play/whatif/what_if_lane.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"
#include "render/scene/areas.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace trembler::ui {
namespace {

// Pixels at UI scale 1.
constexpr float panelsWidth = 620;
constexpr float inspectorWidth = 324;
constexpr float leastForGoalAndPanel = 600; ///< height of the window

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
    bool narrow = false;        ///< the window
    bool narrowSuccess = false; ///< at the right and not in the middle
};

/// In a small window a panel takes the place of the goal or the toolbox, and is hidden behind cards that the
/// player must see or has opened later.
Beside cardsBeside(PlayParts const& parts) {
    render::Window const& window = parts.context.window;
    float const width = static_cast<float>(window.size().width) / window.uiScale();
    float const height = static_cast<float>(window.size().height) / window.uiScale();
    bool const panel = parts.components.open() || (parts.hasMods() && parts.modsPanel.open());
    LevelFile const& level = parts.session.level();
    bool const boxed = !level.toolbox.empty() || level.wires > 0;
    Beside beside;
    bool const inspects = parts.inspector.open() || parts.why.open(); // one in the place of the other
    beside.narrow = width < roomyWidth;
    beside.success = parts.celebration.showing() && !(beside.narrow && parts.why.open());
    beside.narrowSuccess = beside.narrow || (boxed && !inspects);
    bool const atRight = inspects || (beside.success && beside.narrowSuccess);
    bool const roomForBoth = width >= panelsWidth + inspectorWidth + 3 * cardGap;
    beside.panels = panel && (roomForBoth || !atRight);
    beside.goal = !beside.panels || height >= leastForGoalAndPanel;
    beside.toolbox = parts.run.building() && !inspects && (roomForBoth || !beside.panels);
    return beside;
}

/// The components panel or that of mods, between the cards at the top of the screen and the row of tools.
void drawPanels(PlayParts& parts, float screen, float bottom, Beside const& beside) {
    UiContext& context = parts.context;
    float top = beside.goal ? 150 : cornerRow;
    for (char const* above : {"goal", "success"}) {
        if (beside.narrowSuccess && above == std::string_view("success")) {
            continue;
        }
        if (auto const card = context.layout.card(above)) {
            top = std::max(top, static_cast<float>(card->high.y) / context.window.uiScale() + cardGap);
        }
    }
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
    try {
        std::string const content = ending == ".csv" ? probes.csv() : probes.svg(parts.timeline.last());
        auto const path = context.recorder.writeText("plot", ending.c_str(), content);
        context.toasts.add(textWith("Saved: {}", path.string()), render::ToastKind::News, 6);
    } catch (std::runtime_error const& error) {
        context.toasts.add(translated(error.what()), render::ToastKind::Trouble, 6);
    }
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

SuccessLook successLook(PlayParts const& parts, bool narrow) {
    SuccessLook look{.narrow = narrow, .moving = !parts.context.profile.settings().reducedMotion};
    if (!parts.celebration.showing()) {
        return look;
    }
    AfterLevel const after = afterThis(parts);
    look.last = after == AfterLevel::end;
    if (after == AfterLevel::gallery) {
        look.next = text("success.gallery");
    } else if (after == AfterLevel::levels) {
        look.next = text("success.levels");
    }
    return look;
}

} // namespace

std::optional<std::size_t> drawPlayCards(PlayParts& parts, CommandSet const& commands) {
    UiContext& context = parts.context;
    parts.said.follow();
    Layout& layout = context.layout;
    Session const& session = parts.session;
    CommandButtons buttons(layout, context.keys, commands);
    // While it runs the card covers as little as possible, unless hints are being read.
    bool const inPlay = !parts.run.building() && parts.hintsShown == 0;
    Beside const beside = cardsBeside(parts);
    bool const choosing =
        parts.timeline.shown() && (parts.timeline.probes().choosing() || parts.whatIf->active());
    parts.goalAside = goalInTheWay(parts);
    if (beside.goal && !parts.goalAside && !(choosing && beside.narrow)) { // the card of plots takes its room
        auto const asked = drawGoalCard(layout, session,
                                        {.said = &parts.said,
                                         .hintsShown = parts.hintsShown,
                                         .brief = parts.components.open() || parts.modsPanel.open() || inPlay,
                                         .task = parts.ofGallery,
                                         .counts = parts.goalCounts,
                                         .goals = parts.timeline.goals(),
                                         .below = parts.timeline.shown() ? parts.timeline.height() + 6 : 0,
                                         .why = parts.why.canAsk()},
                                        &buttons);
        if (asked) {
            parts.inspector.close();
            parts.why.askGoal(*asked);
        }
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
        drawSuccess(buttons, session, parts.celebration, successLook(parts, beside.narrowSuccess));
    }
    float const screen = static_cast<float>(context.window.size().height) / context.window.uiScale();
    if (!(beside.success && beside.narrow)) {
        float const height = screen - cornerRow - bottom - 8;
        if (parts.inspector.open()) {
            parts.why.close(); // the player has chosen an object since
        }
        if (auto const wanted = parts.why.draw(layout, cornerRow, height)) {
            parts.lookAt(*wanted);
        }
        bool const mayAsk = !parts.run.building() && parts.why.canAsk();
        std::string const whyTip = withKey(words::whyObjectTip, "why", context.keys);
        if (parts.inspector.draw(layout, session, cornerRow, height,
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
