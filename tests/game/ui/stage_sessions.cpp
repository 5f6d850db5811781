#include "tests/game/ui/stage_sessions.hpp"

#include "game/ui/play/view/level_extents.hpp"
#include "game/ui/play/whatif/what_if.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "render/scene/areas.hpp"
#include "render/scene/facts/pick.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace trembler::ui::test {
namespace {

/// Commands that move the view, and those that write files or leave the level.
constexpr std::array notAllowed{"fit",     "view-left",  "view-right", "view-up", "view-down",
                                "zoom-in", "zoom-out",   "move-view",  "record",  "picture",
                                "save",    "next-level", "fullscreen", "restart", "solutions"};
/// Items whose button does such a thing, or opens another level.
constexpr std::array notPressed{"fit", "record", "picture", "save", "next level", "free play"};

bool isOneOf(std::string_view name, auto const& all) {
    return std::find(all.begin(), all.end(), name) != all.end();
}

constexpr std::array stageSizes{render::Size{800, 600}, render::Size{1280, 720}, render::Size{1280, 800},
                                render::Size{1920, 1080}, render::Size{3840, 2160}};

} // namespace

void resizeWindow(Player& player, render::Size size) {
    window().resize(size);
    SDL_Event event{};
    event.type = SDL_WINDOWEVENT;
    event.window.event = SDL_WINDOWEVENT_SIZE_CHANGED;
    event.window.windowID = SDL_GetWindowID(window().handle());
    event.window.data1 = size.width;
    event.window.data2 = size.height;
    SDL_PushEvent(&event);
    player.frames(FittedView::settling + 2);
}

Rect widestFree(Layout const& layout, render::Size window, double leastHeight) {
    std::vector<Rect> cards;
    for (char const* const name : {"goal", "toolbox", "transport", "tools", "corner"}) {
        if (auto const card = layout.card(name)) {
            cards.push_back(*card);
        }
    }
    std::vector<double> xs{0, static_cast<double>(window.width)};
    std::vector<double> ys{0, static_cast<double>(window.height)};
    for (Rect const& card : cards) {
        xs.insert(xs.end(), {card.low.x, card.high.x});
        ys.insert(ys.end(), {card.low.y, card.high.y});
    }
    Rect widest{};
    for (double const left : xs) {
        for (double const right : xs) {
            for (double const top : ys) {
                for (double const bottom : ys) {
                    Rect const free{{left, top}, {right, bottom}};
                    bool const wider = right - left > widest.high.x - widest.low.x;
                    if (wider && bottom - top >= leastHeight &&
                        std::none_of(cards.begin(), cards.end(),
                                     [&](Rect const& card) { return card.overlaps(free); })) {
                        widest = free;
                    }
                }
            }
        }
    }
    return widest;
}

StageSession::StageSession(Player& player, std::uint64_t seed)
    : player_(player), random_(seed), scene_(focusOf(player.session())) {
    LevelFile const& level = player.session().level();
    for (Area const& area : level.placing.value_or(std::vector<Area>{})) {
        scene_.add(render::extentOf(area));
    }
    scene_.add(GoalAreas(level).extent());
    scene_ = scene_.widened(0.06 * render::length(scene_.half()));
}

Point StageSession::anywhere() {
    render::Size const size = window().size();
    return {static_cast<double>(below(static_cast<std::size_t>(size.width))),
            static_cast<double>(below(static_cast<std::size_t>(size.height)))};
}

/// In the scene.
Vec2 StageSession::somewhere() {
    auto const share = [this] { return static_cast<double>(below(1001)) / 1000; };
    return {scene_.lower.x + share() * 2 * scene_.half().x, scene_.lower.y + share() * 2 * scene_.half().y};
}

std::string StageSession::place() {
    std::vector<Point> tiles;
    for (Placed const& item : player_.layout().items()) {
        if (item.name.starts_with("part ")) {
            tiles.push_back(item.rect.middle());
        }
    }
    if (tiles.empty()) {
        return "no tile";
    }
    Vec2 const to = somewhere();
    player_.drag(tiles[below(tiles.size())], player_.at(to), MouseButton::Left, 2);
    return fmt::format("place at {:.2f} {:.2f}", to.x, to.y);
}

std::string StageSession::movePlaced() {
    auto const& placed = player_.session().placed();
    bool const building = player_.session().mode() == SessionMode::building; // in a run see grab()
    if (!building || placed.empty() || player_.play().placing().carried() ||
        player_.play().wires().laying() || player_.play().wires().cutting()) {
        return "nothing to move";
    }
    PlacedPart const part = placed[below(placed.size())];
    Vec2 const at = part.placement.at;
    ObjectId const under = render::pick(player_.session().world(), {at.x, at.y});
    bool const covered = !player_.layout().cardAt(player_.at(at)).empty();
    if (covered || !under.valid() || player_.session().numberOf(under) != part.number) {
        return "covered"; // a drag from there would be one of something else
    }
    Vec2 const to = somewhere();
    player_.drag(player_.at(at), player_.at(to), MouseButton::Left, 2);
    return fmt::format("move {} to {:.2f} {:.2f}", part.placement.part, to.x, to.y);
}

/// In a run: an object that is not fixed, so that the drag is none of the paper.
std::string StageSession::grab() {
    PlayScreen& play = player_.play();
    World const& world = player_.session().world();
    if (player_.session().mode() == SessionMode::building || play.run().watching() ||
        play.timeline().looksBack() || play.whatIf().active() || play.hand().cutting()) {
        return "nothing to grab";
    }
    Vec2 const at = somewhere();
    ObjectId const under = render::pick(world, {at.x, at.y});
    if (!under.valid() || world.find<Fixed>(under) != nullptr ||
        !player_.layout().cardAt(player_.at(at)).empty()) {
        return "nothing there";
    }
    player_.moveTo(player_.at(at));
    player_.press();
    bool const held = play.hand().busy(); // it may have moved meanwhile
    if (held) {
        player_.moveTo(player_.at(somewhere()));
    }
    player_.release();
    return "grab";
}

std::string StageSession::click() {
    Point const at = anywhere();
    for (Placed const& item : player_.layout().items()) {
        if (item.rect.contains(at) && isOneOf(item.name, notPressed)) {
            return "not " + item.name;
        }
    }
    auto const button = below(6) == 0 ? MouseButton::Right : MouseButton::Left;
    player_.click(at, button);
    return fmt::format("click at {:.0f} {:.0f}", at.x, at.y);
}

std::string StageSession::press() {
    auto const& items = player_.layout().items();
    if (items.empty()) {
        return "no item";
    }
    Placed const item = items[below(items.size())];
    if (isOneOf(item.name, notPressed)) {
        return "not " + item.name;
    }
    player_.click(item.rect.middle());
    return "press " + item.name;
}

std::string StageSession::command() {
    CommandSet& commands = player_.play().commands();
    CommandInfo const& info = commands.info(below(commands.size()));
    auto const keys = player_.app().context().keys.keysOf(info.id);
    if (keys.empty() || render::isPadKey(keys.front().key) || isOneOf(info.id, notAllowed)) {
        return "no key";
    }
    Chord const chord = keys.front();
    unsigned const modifiers = (chord.ctrl ? unsigned{KMOD_LCTRL} : 0U) |
                               (chord.shift ? unsigned{KMOD_LSHIFT} : 0U) |
                               (chord.alt ? unsigned{KMOD_LALT} : 0U);
    std::string what = "command " + std::string(info.id);
    player_.key(chord.key, modifiers);
    return what;
}

std::string StageSession::wait() {
    int const frames = 1 + static_cast<int>(below(48));
    player_.simulate(frames);
    return fmt::format("wait {}", frames);
}

std::string StageSession::moveView() {
    switch (below(6)) {
    case 0:
        player_.key(SDLK_HOME);
        return "fit";
    case 1: {
        constexpr std::array arrows{SDLK_LEFT, SDLK_RIGHT, SDLK_UP, SDLK_DOWN};
        for (std::size_t presses = 1 + below(12); presses > 0; --presses) {
            player_.key(arrows[below(arrows.size())], KMOD_LCTRL);
        }
        return "look around";
    }
    case 2:
        player_.key(below(2) == 0 ? SDLK_EQUALS : SDLK_MINUS, KMOD_LCTRL);
        return "zoom";
    case 3: {
        player_.moveTo(anywhere());
        int const notches = static_cast<int>(below(9)) - 4;
        player_.wheel(notches);
        return fmt::format("wheel {}", notches);
    }
    default: {
        constexpr std::array buttons{MouseButton::Left, MouseButton::Middle, MouseButton::Right};
        Point const from = anywhere();
        Point const to = anywhere();
        player_.drag(from, to, buttons[below(buttons.size())], 3);
        return fmt::format("drag {:.0f} {:.0f} to {:.0f} {:.0f}", from.x, from.y, to.x, to.y);
    }
    }
}

std::string StageSession::resize() {
    render::Size const size = stageSizes[below(stageSizes.size())];
    resizeWindow(player_, size);
    return fmt::format("size {}x{}", size.width, size.height);
}

void StageSession::closeMenus() {
    for (int i = 0; i < 8 && player_.app().menu().isOpen(); ++i) {
        player_.key(SDLK_ESCAPE);
    }
}

bool StageSession::goesOn() {
    return player_.findPlay() != nullptr && !player_.app().menu().isOpen();
}

void StageSession::expectOnStage() {
    Rect const stage = player_.play().stage();
    Rect const scene = onScreen(player_.play().camera(), scene_);
    ASSERT_TRUE(scene.overlaps(stage)) << "nothing of the scene is on the stage after" << story_;
}

void StageSession::act() {
    using Act = std::string (StageSession::*)();
    constexpr std::array<Act, 14> still{
        &StageSession::place,   &StageSession::place,   &StageSession::movePlaced, &StageSession::grab,
        &StageSession::click,   &StageSession::press,   &StageSession::press,      &StageSession::press,
        &StageSession::command, &StageSession::command, &StageSession::command,    &StageSession::command,
        &StageSession::wait,    &StageSession::wait};
    std::size_t const kind = below(20);
    bool const moves = kind >= still.size();
    render::Camera const before = player_.play().camera();
    Act const act = !moves ? still.at(kind) : kind < 19 ? &StageSession::moveView : &StageSession::resize;
    story_ += "\n  " + (this->*act)();
    closeMenus();
    if (!goesOn()) {
        return;
    }
    player_.frames(2); // also nothing of it comes later
    if (!moves) {
        render::Camera const& now = player_.play().camera();
        ASSERT_EQ(now.centre, before.centre) << "after" << story_;
        ASSERT_EQ(now.pixelsPerMetre, before.pixelsPerMetre) << "after" << story_;
        ASSERT_EQ(now.viewport, before.viewport) << "after" << story_;
    }
    expectOnStage();
}

} // namespace trembler::ui::test
