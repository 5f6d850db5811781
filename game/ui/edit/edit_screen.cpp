#include "game/ui/edit/edit_screen.hpp"

#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/commands/edit_commands.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/panels/bars.hpp"
#include "game/ui/edit/panels/palette_entries.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "game/ui/edit/study/level_studies.hpp"
#include "game/ui/edit/view/edit_drawing.hpp"
#include "game/ui/shared/card_sizes.hpp"
#include "game/ui/shared/commands/carry_out_keys.hpp"
#include "game/ui/shared/commands/key_bindings.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"
#include "render/window/gamepad.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

namespace trembler::ui {
namespace {

using namespace render;

/// From the right edge of the window to the left of the buttons in its corner, pixels at UI scale 1.
constexpr float besideCorner = cornerWidth + 2 * cardGap;
/// Of the two buttons there, and a gap.
constexpr float besideCornerWidth = 2 * 40 + 7 + cardGap;

bool isNarrow() {
    return ImGui::GetIO().DisplaySize.x / theme().scale < roomyWidth;
}

void drawEditVeil() {
    ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, ImGui::GetIO().DisplaySize,
                                                  imColour(faded(palette::paper, 0.6F)));
}

/// The buttons of a gamepad, by default, whose commands act while the panel has the keyboard.
constexpr std::array leadingButtons{padKey(SDL_CONTROLLER_BUTTON_BACK), padKey(SDL_CONTROLLER_BUTTON_START),
                                    padKey(SDL_CONTROLLER_BUTTON_LEFTSTICK)};

} // namespace

EditScreen::EditScreen(UiContext& context, std::filesystem::path const& file, EditOptions options)
    : parts_(context, std::move(options)), commands_(editCommands(), parts_),
      testCommands_(testCommands(), parts_) {
    if (!file.empty()) {
        parts_.openFile(file);
    }
    parts_.problems.refresh(parts_.document);
    if (!parts_.dialogs.isOpen()) {
        edit::RecoveryTroubles troubles;
        if (auto const recovery = edit::findRecovery(parts_.options.recovery, file, &troubles)) {
            parts_.dialogs.offerRecovery({*recovery});
        }
        for (DamagedFile const& one : troubles.damaged) {
            context.toasts.add(inWords(one), ToastKind::Trouble, 12);
        }
        for (InputError const& one : troubles.notRead) {
            context.toasts.add(notReadable(one), ToastKind::Trouble, 12);
        }
        if (troubles.leftOut > 0) {
            context.toasts.add(
                textWith("kept.recoveries_left_out", troubles.leftOut, shownPath(parts_.options.recovery)),
                ToastKind::Trouble, 12);
        }
    }
}

void EditScreen::setView() {
    auto const scale = static_cast<double>(parts_.context.window.uiScale());
    parts_.view.setView(parts_.context.window.size(), {scale * toolColumn, scale * topBar,
                                                       scale * (sidePanelWidth + 24), scale * statusRow});
    // The view is the designer's: it does not follow a dragged object.
    parts_.view.stay();
}

CommandSet& EditScreen::commands() {
    return parts_.test != nullptr ? parts_.test->commands() : commands_;
}

std::span<Gesture const> EditScreen::gestures() const {
    return parts_.test != nullptr ? parts_.test->gestures() : editGestures();
}

void EditScreen::drawTestCard() {
    UiContext& context = parts_.context;
    // Where the buttons at the bottom leave no room it stands beside those at the top, without words.
    bool const narrow = isNarrow();
    CardOptions const beside{.anchor = Anchor::TopRight, .offset = {besideCorner, cardGap}, .bare = true};
    CardOptions const below{.anchor = Anchor::BottomRight, .bare = true};
    context.layout.beginCard("test", "", narrow ? beside : below);
    std::string const tip = withKey(parts_.recordsOver.empty() ? words::recordIt : words::recordAgainIt,
                                    "edit-record", context.keys);
    bool const record = iconButton("record solution", Icon::Save, tip.c_str(), false,
                                   parts_.test->session().mode() != SessionMode::building);
    context.layout.item("record solution");
    ImGui::SameLine(0, scaled(7));
    bool const back = narrow ? iconButton("back", Icon::Back, words::testBack, true)
                             : bigButton(words::testBack, {.icon = Icon::Back, .look = ButtonLook::Primary});
    context.layout.item("back to editor");
    context.layout.endCard();
    if (record) {
        actions::recordSolution(parts_);
    } else if (!context.gui.wantsKeyboard()) {
        carryOutKeys(context.input.events(), context.keys, testCommands_);
    }
    if (back) {
        actions::endTest(parts_);
    }
}

void EditScreen::updateTest(double seconds) {
    parts_.goals.follow(parts_.test->session());
    parts_.test->keepBesideCorner(isNarrow() ? besideCornerWidth : 0);
    auto asked = parts_.test->update(seconds);
    parts_.goals.follow(parts_.test->session());
    parts_.autosave->tick(parts_.document, seconds);
    if (asked && std::holds_alternative<request::OpenMenu>(*asked) &&
        (std::get<request::OpenMenu>(*asked).page == MenuPage::main ||
         std::get<request::OpenMenu>(*asked).page == MenuPage::ending)) {
        asked.reset(); // Esc, the menu's button and the buttons after a solved level lead back
        return actions::endTest(parts_);
    }
    if (asked && std::holds_alternative<request::OpenLevel>(*asked)) {
        asked.reset(); // "next level" of a test: there is none but this one
        return actions::endTest(parts_);
    }
    parts_.request = asked;
    bool const running = parts_.test->session().mode() != SessionMode::building;
    // The card of success comes to the same corner and says the same.
    bool const success = parts_.context.layout.card("success").has_value();
    if (running && !success && !parts_.test->inspector().open() && !parts_.test->why().open()) {
        drawLiveGoals(parts_, cornerRow);
    }
    drawTestCard();
}

void EditScreen::drawDialogs() {
    UiContext& context = parts_.context;
    drawEditVeil();
    if (parts_.browser.isOpen()) {
        auto const purpose = parts_.browser.purpose();
        if (auto const file = parts_.browser.draw(context)) {
            if (purpose == FileBrowser::Purpose::open) {
                parts_.openFile(*file);
            } else {
                // The browser has asked whether a file is to be replaced.
                actions::saveTo(parts_, *file, edit::LevelDocument::Overwrite::yes);
            }
        } else if (!parts_.browser.isOpen()) {
            parts_.giveUpLeaving();
        }
    } else if (parts_.palette.isOpen()) {
        std::vector<PaletteEntry> const others = partsAndJoints(parts_);
        auto const chosen = parts_.palette.draw(context, commands_, others);
        if (chosen && *chosen >= commands_.size()) {
            takeFound(parts_, others[*chosen - commands_.size()]);
        } else if (chosen) {
            commands_.run(*chosen);
        }
    } else {
        parts_.dialogs.draw(parts_);
    }
}

/// While the panel has the keyboard, the shoulders of a gamepad turn its pages.
void EditScreen::turnPages() {
    constexpr int pages = static_cast<int>(Tab::problems) + 1;
    MenuKeys const& keys = parts_.context.menuKeys;
    int const by = (keys.pressed(MenuKey::pageNext) ? 1 : 0) - (keys.pressed(MenuKey::pageBefore) ? 1 : 0);
    parts_.tab = static_cast<Tab>((static_cast<int>(parts_.tab) + by + pages) % pages);
}

void EditScreen::handleKeys() {
    UiContext& context = parts_.context;
    bool const escape = context.menuKeys.pressed(MenuKey::back);
    keysOwner_.look(!parts_.partInHand.empty());
    if (escape && KeysOwner::popup()) { // a menu or a drop-down
        ImGui::ClosePopupToLevel(0, true);
    }
    if (keysOwner_.widgets()) {
        return;
    }
    if (escape && mouse_.cancel(parts_)) {
        return;
    }
    if (parts_.panelKeys) {
        turnPages();
        std::vector<SDL_Event> events;
        std::copy_if(context.input.events().begin(), context.input.events().end(), std::back_inserter(events),
                     [&](SDL_Event const& event) {
                         return passesWidgets(event, context.keys, commands_, leadingButtons);
                     });
        carryOutKeys(events, context.keys, commands_);
        return;
    }
    carryOutKeys(context.input.events(), context.keys, commands_);
}

std::optional<ScreenRequest> EditScreen::update(double seconds) {
    parts_.request.reset();
    auto const chosen = takeNext();
    if (parts_.test != nullptr) {
        if (chosen) {
            parts_.test->runNext(*chosen);
        }
        updateTest(seconds);
        return std::exchange(parts_.request, std::nullopt);
    }
    UiContext& context = parts_.context;
    setView();
    bool const busy = mouse_.doing() != EditMouse::Doing::nothing || !parts_.partInHand.empty();
    parts_.pointer = reader_.read(context, parts_.camera(), busy);
    bool const dialog = parts_.dialogOpen();
    if (dialog) {
        parts_.pointer.overCard = true;
        parts_.pointer.pressed = false;
    }
    if (dialog) { // alone, as the menu is: nothing behind it can be pressed
        drawDialogs();
    } else {
        if (drawSidePanel(parts_, commands_).tookPart) {
            mouse_.tookPart();
        }
        if (auto const asked = drawBars(parts_, commands_)) {
            commands_.run(*asked);
        }
        if (chosen) {
            commands_.run(*chosen);
        }
        handleKeys();
        if (parts_.test == nullptr && !parts_.dialogOpen()) {
            mouse_.update(parts_);
        }
    }
    parts_.follow(seconds, mouse_.doing() != EditMouse::Doing::nothing);
    return std::exchange(parts_.request, std::nullopt);
}

void EditScreen::updateBehindMenu(double seconds) {
    if (parts_.test != nullptr) {
        parts_.test->updateBehindMenu(seconds);
        return;
    }
    setView();
    mouse_.cancel(parts_);
    parts_.follow(seconds);
}

bool EditScreen::keepsPicture() const {
    return parts_.test != nullptr && parts_.test->keepsPicture();
}

bool EditScreen::still() const {
    if (parts_.test != nullptr) {
        return parts_.test->still();
    }
    // The list of problems follows a change later, but sooner than the program takes pictures to be at rest.
    return mouse_.doing() == EditMouse::Doing::nothing && !parts_.studies->busy();
}

void EditScreen::draw() {
    if (parts_.test != nullptr) {
        parts_.test->draw();
    } else {
        drawEditedScene(parts_, mouse_);
    }
}

void EditScreen::pictureComplete() {
    if (parts_.test != nullptr) {
        parts_.test->pictureComplete();
    }
}

bool EditScreen::mayLeaveFor(ScreenRequest const& asked) {
    if (!parts_.document.modified() || parts_.document.readOnly()) {
        return true;
    }
    if (parts_.leaving && asked.index() == parts_.leaving->index() && std::exchange(leaveAgreed_, false)) {
        parts_.leaving.reset();
        return true; // a level that then cannot be opened leaves the question to be asked again
    }
    actions::endTest(parts_);
    parts_.leaving = asked;
    parts_.dialogs.askUnsaved([this](EditParts& parts) {
        leaveAgreed_ = true;
        if (parts.leaving) {
            parts.request = parts.leaving;
        }
    });
    return false;
}

void EditScreen::leave() {
    actions::endTest(parts_);
    parts_.studies->stopAll();
    // In order: the designer has given up the unsaved changes.
    parts_.autosave->close();
    parts_.context.pending.forget(Owned::unsavedLevel);
}

} // namespace trembler::ui
