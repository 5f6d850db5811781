#include "game/ui/play/play_screen.hpp"

#include "game/ui/play/all_cards.hpp"
#include "game/ui/play/commands/play_commands.hpp"
#include "game/ui/play/field_drawing.hpp"
#include "game/ui/play/lesson/lesson_drawing.hpp"
#include "game/ui/play/mouse/second_player.hpp"
#include "game/ui/play/whatif/what_if_card.hpp"
#include "game/ui/shared/commands/carry_out_keys.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/window/gamepad.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace trembler::ui {
namespace {

/// The direction that is held on a gamepad, in steps. Keys are left to the keyboard's repetition.
Vec2 padDirection(UiContext const& context) {
    auto const held = [&](std::string_view command) {
        auto const keys = context.keys.keysOf(command);
        return std::any_of(keys.begin(), keys.end(),
                           [&](Chord const& chord) {
                               return render::isPadKey(chord.key) && context.input.keyHeld(chord.key);
                           })
                   ? 1.0
                   : 0.0;
    };
    return {held("move-right") - held("move-left"), held("move-up") - held("move-down")};
}

/// The buttons of a gamepad, by default, whose commands act while a card has the keyboard.
constexpr std::array leadingButtonsOfPlay{render::padKey(SDL_CONTROLLER_BUTTON_START),
                                          render::padKey(SDL_CONTROLLER_BUTTON_LEFTSHOULDER),
                                          render::padKey(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER)};

} // namespace

PlayScreen::PlayScreen(UiContext& context, std::filesystem::path file, std::shared_ptr<GameData const> data,
                       WorldOptions const& options, LevelFile const* stated)
    : parts_(context, std::move(file), std::move(data), options, stated), commands_(playCommands(), parts_) {}

std::span<Gesture const> PlayScreen::gestures() const {
    return playGestures();
}

std::optional<ScreenRequest> PlayScreen::update(double seconds) {
    UiContext& context = parts_.context;
    parts_.request.reset();
    parts_.passMods(seconds);
    parts_.run.beginPicture(isHeld(context.input, context.keys, "fast"));
    fittedView_.follow(parts_, true);
    Pointer const mouse = reader_.read(context, parts_.camera(),
                                       parts_.placing.carried().has_value() || parts_.group.dragging() ||
                                           parts_.hand.busy() || parts_.secondHand.busy());
    bool const cardKeys = parts_.whatIfTool->cardHasKeys();
    passKeysToCard(cardKeys);
    holdDirection(cardKeys ? Vec2{} : padDirection(context), seconds, mouse);
    parts_.pointer =
        parts_.keyPointer.instead(mouse, parts_.camera(), isHeld(context.input, context.keys, "act"),
                                  !cardKeys && !context.gui.wantsKeyboard());
    parts_.allBack.pass(seconds);
    parts_.why.pass();
    if (!parts_.run.building()) {
        parts_.allBack.forget();
    }
    if (auto const asked = drawPlayCards(parts_, commands_)) {
        commands_.run(*asked);
    }
    if (auto const chosen = takeNext()) {
        commands_.run(*chosen);
    }
    if (cardKeys) {
        handleKeysBesideCard();
    } else if (!context.gui.wantsKeyboard()) {
        tellOfRefused(carryOutKeys(context.input.events(), context.keys, commands_));
    }
    auto const handle = parts_.handle();
    bool const second = !parts_.movesView && isHeld(context.input, context.keys, "second-hand");
    FieldMouse::Surroundings const around{handle ? std::optional(handle->at) : std::nullopt,
                                          parts_.run.watching(), parts_.timeline.looksBack(),
                                          parts_.whatIfTool->update(parts_.pointer, second), second};
    parts_.picking.show(parts_.timeline.looksBack() ? &parts_.shownWorld() : nullptr);
    if (parts_.mouse.update(parts_.pointer, around, seconds)) {
        parts_.newWorld();
    }
    lookAtHover(seconds);
    useSecondPlayer(seconds);
    parts_.timeline.pass(seconds, parts_.run.speed().now());
    parts_.whatIf->pass();
    parts_.run.advance(seconds, parts_.film.recording());
    for (auto const& trouble : {parts_.timeline.takeTrouble(), parts_.whatIf->takeTrouble()}) {
        if (trouble) {
            context.toasts.add(translated(*trouble), render::ToastKind::Trouble, 8);
        }
    }
    tellOfSlowness();
    parts_.celebration.pass(seconds);
    parts_.lesson.look(context.input.events(), seconds);
    drawLesson(parts_);
    parts_.sparks.pass(seconds);
    parts_.cuts.pass(seconds);
    parts_.showCut();
    parts_.squash.look(parts_.session, seconds, !context.profile.settings().reducedMotion);
    sinceStep_ = parts_.run.running() || parts_.run.stepped() ? 0 : sinceStep_ + seconds;
    parts_.keepBuild(seconds);
    parts_.touches.look({.carrying = parts_.placing.carried() || parts_.group.dragging(),
                         .building = parts_.run.building(),
                         .solved = parts_.celebration.solvedAt().has_value(),
                         .troubles = context.toasts.troubles(),
                         .world = &parts_.session.world()});
    return parts_.request;
}

void PlayScreen::lookAtHover(double seconds) {
    bool const busy = parts_.placing.carried() || parts_.group.dragging() || parts_.hand.busy() ||
                      parts_.secondHand.busy() || parts_.hand.cutting() || parts_.wires.laying() ||
                      parts_.wires.cutting() || parts_.shown.names;
    ObjectId const under = parts_.picking.hovered();
    // The player has just put the selected part there, and its tile has its name.
    bool const own = parts_.placing.selected() && parts_.session.numberOf(under) == parts_.placing.selected();
    parts_.hoverName.look(busy || own ? ObjectId{} : under, render::length(parts_.context.input.mouseMoved()),
                          seconds);
}

void PlayScreen::holdDirection(Vec2 direction, double seconds, Pointer const& mouse) {
    UiContext& context = parts_.context;
    if (!parts_.movesView) {
        parts_.keyPointer.holdDirection(direction, seconds, context.shiftHeld(), mouse, parts_.camera());
        return;
    }
    constexpr double windowsPerSecond = 0.6; // after the step that the key's own event makes
    viewHeld_ = lengthSquared(direction) > 0 ? viewHeld_ + std::clamp(seconds, 0.0, 0.25) : 0;
    if (viewHeld_ > 0.3) {
        Vec2 const shares = direction * (windowsPerSecond * std::clamp(seconds, 0.0, 0.25));
        parts_.view.look({shares.x, shares.y});
    }
}

void PlayScreen::handleKeysBesideCard() {
    UiContext& context = parts_.context;
    std::vector<SDL_Event> events;
    std::copy_if(context.input.events().begin(), context.input.events().end(), std::back_inserter(events),
                 [&](SDL_Event const& event) {
                     return passesWidgets(event, context.keys, commands_, leadingButtonsOfPlay);
                 });
    bool const dropDown = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (std::exchange(dropDownWasOpen_, dropDown) || dropDown || context.gui.wantsKeyboard()) {
        return; // Esc closes it, or ends the typing of a number
    }
    carryOutKeys(events, context.keys, commands_);
}

void PlayScreen::useSecondPlayer(double seconds) {
    UiContext& context = parts_.context;
    auto const scale = static_cast<double>(context.window.uiScale());
    bool const playsAlready = parts_.secondPointer.active();
    parts_.secondPointer.look(secondPlayerNow(context, playsAlready), seconds, parts_.camera(), scale);
    bool const keyHeld = isHeld(context.input, context.keys, "second-hand");
    if (playsAlready && !parts_.secondPointer.active() && !keyHeld) {
        parts_.secondHand.letGo(); // the player has gone
    }
    if (!parts_.secondPointer.active() || keyHeld || parts_.run.building() || parts_.run.watching() ||
        parts_.timeline.looksBack()) {
        return; // a held key lends the second hand to the first player
    }
    Pointer const pointer = parts_.secondPointer.pointer(parts_.camera(), scale);
    constexpr double reach = 6; // pixels at UI scale 1
    ObjectId const under =
        render::pick(parts_.session.world(), {pointer.world.x, pointer.world.y}, reach * pointer.pixel);
    parts_.secondHand.update(pointer, under, seconds);
}

void PlayScreen::tellOfRefused(std::optional<std::size_t> command) {
    bool const building = parts_.run.building();
    UiContext& context = parts_.context;
    bool const fast = building && isHeld(context.input, context.keys, "fast");
    bool const first = fast && !std::exchange(fastRefused_, true);
    fastRefused_ = fast;
    if (!first && !command) {
        return;
    }
    if (char const* const why = command ? commands_.whyNot(*command) : nullptr) {
        if (context.toasts.newest() != why) { // as long as it is read it need not be said again
            context.toasts.add(why, render::ToastKind::News, 2.5);
        }
        return;
    }
    CommandGroup const group = command ? commands_.info(*command).group : CommandGroup::running;
    if (building && group == CommandGroup::running) {
        context.toasts.add(text("keys.only_in_run"), render::ToastKind::News, 2);
    } else if (!building && group == CommandGroup::building) {
        context.toasts.add(text("keys.only_building"), render::ToastKind::News, 2);
    }
}

void PlayScreen::tellOfSlowness() {
    Speed const& speed = parts_.run.speed();
    auto const reached = parts_.run.running() ? speed.onlyReached() : std::nullopt;
    if (reached && toldOfSlownessAt_ != speed.now()) {
        toldOfSlownessAt_ = speed.now();
        parts_.context.toasts.add(words::tooSlow(speed.now(), *reached), render::ToastKind::News, 5);
    }
}

void PlayScreen::updateBehindMenu(double seconds) {
    parts_.keepBuild(seconds);
    fittedView_.follow(parts_, false);
    parts_.run.beginPicture(false);
    parts_.touches.forget();
    parts_.placing.cancel();
    parts_.whatIfTool->giveCardKeys(false);
    passKeysToCard(false);
}

// Scripts and a time budget need no pictures of their own: pictures that are not drawn look at the scripts'
// files, too, and a budget decides only between the frames of a run.
bool PlayScreen::still() const {
    constexpr double ringsOut = 3; // s, in which the last sounds die away
    bool const celebrates = parts_.celebration.showing() && parts_.celebration.age() < 5;
    bool const moves = lengthSquared(padDirection(parts_.context)) > 0;
    return sinceStep_ > ringsOut && !celebrates && !moves && !parts_.lesson.moving() &&
           !parts_.timeline.moving() && !parts_.whatIf->moving() && !parts_.squash.moving() &&
           !parts_.cuts.moving() && !parts_.secondPointer.moving() && parts_.sparks.sparks().empty() &&
           !parts_.allBack.waiting() && !parts_.hoverName.waiting() && !parts_.why.busy();
}

bool PlayScreen::keepsPicture() const {
    return parts_.film.wants(parts_.run.stepped()) || (parts_.film.recording() && parts_.run.stepped());
}

void PlayScreen::draw() {
    drawField(parts_);
}

void PlayScreen::pictureComplete() {
    parts_.film.take([this] { return parts_.context.window.readPixels(); }, parts_.run.stepped());
}

void PlayScreen::keep() {
    parts_.keepBuild(BuildKeeper::delay);
}

void PlayScreen::leave() {
    passKeysToCard(false);
    keep();
    parts_.audio.leave();
    parts_.film.end();
}

std::optional<Vec2> PlayScreen::handle() {
    auto const found = parts_.handle();
    return found ? std::optional(found->at) : std::nullopt;
}

} // namespace trembler::ui
