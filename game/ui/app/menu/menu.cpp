#include "game/ui/app/menu/menu.hpp"

#include "game/ui/app/menu/help_page.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <span>
#include <string>

namespace trembler::ui {
namespace {

using namespace render;

/// Dims the world behind the menu.
void drawVeil() {
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, screen, imColour(faded(palette::paper, 0.80F)));
}

char const* pageName(MenuPage page) {
    switch (page) {
    case MenuPage::main:
        return "main";
    case MenuPage::settings:
        return "settings";
    case MenuPage::keys:
        return "keys";
    case MenuPage::levels:
        return "levels";
    case MenuPage::gallery:
        return "gallery";
    case MenuPage::ending:
        return "ending";
    case MenuPage::solutions:
        return "solutions";
    case MenuPage::help:
        return "help";
    case MenuPage::commands:
        return "commands";
    case MenuPage::closed:
        break;
    }
    return "";
}

constexpr float menuWidth = 340;
constexpr float between = 8; // two buttons in one row

/// A button with the text of that id, as wide as the card unless a width is given.
bool wide(UiContext& context, char const* id, Icon icon, ButtonLook look = ButtonLook::Quiet,
          float width = -1) {
    bool const clicked = bigButton(text(id), {.icon = icon, .look = look, .width = width});
    context.layout.item(id);
    return context.focus.item() || clicked;
}

} // namespace

void Menu::back() {
    keys_.cancel();
    solutions_.cancel();
    if (!pages_.empty()) {
        pages_.pop_back();
    }
}

std::optional<ScreenRequest> Menu::drawMain(UiContext& context, Screen& behind) {
    std::optional<ScreenRequest> asked;
    Layout& layout = context.layout;
    bool const played = behind.commands().has("restart"); // else a level is edited: nothing was paused
    layout.beginCard("menu", text(played ? "menu.paused" : "menu.of_editor"),
                     {.anchor = Anchor::Middle, .width = menuWidth});
    ImGui::Dummy({0, scaled(4)});
    bool const resume = played ? wide(context, "menu.resume", Icon::Play, ButtonLook::Primary)
                               : wide(context, "menu.edit_on", Icon::Back, ButtonLook::Primary);
    bool const restart = played && wide(context, "menu.restart", Icon::Repeat);
    if (behind.loadableSolutions() != nullptr && wide(context, "menu.solutions", Icon::Save)) {
        pages_.push_back(MenuPage::solutions);
    }
    if (wide(context, "menu.levels", Icon::List)) {
        pages_.push_back(MenuPage::levels);
    }
    if (wide(context, "menu.settings", Icon::Settings)) {
        pages_.push_back(MenuPage::settings);
    }
    // In one row, so that the menu fits into the smallest window.
    float const half = 0.5F * (ImGui::GetContentRegionAvail().x / scaled(1) - between);
    if (wide(context, "menu.keys", Icon::Why, ButtonLook::Quiet, half)) {
        pages_.push_back(MenuPage::help);
    }
    ImGui::SameLine(0, scaled(between));
    if (wide(context, "menu.commands", Icon::List, ButtonLook::Quiet, half)) {
        pages_.push_back(MenuPage::commands);
    }
    if (wide(context, "menu.title", Icon::Back, ButtonLook::Quiet, half)) {
        asked = request::ShowTitle{};
    }
    ImGui::SameLine(0, scaled(between));
    if (wide(context, "menu.quit", Icon::Cross, ButtonLook::Quiet, half)) {
        asked = request::Quit{};
    }
    layout.endCard();
    if (resume || restart || asked) {
        close();
    }
    if (restart) {
        behind.commands().run("restart");
    }
    return asked;
}

std::optional<ScreenRequest> Menu::drawLevels(UiContext& context, Screen& behind) {
    if (drawn_ != page()) {
        chapters_.open(context, behind.level(), page() == MenuPage::gallery);
    }
    ChaptersPage::Choice const choice = chapters_.draw(context, behind.level());
    if (choice.back) {
        back();
    }
    return choice.level == nullptr ? std::nullopt
                                   : std::optional<ScreenRequest>(request::OpenLevel{choice.level->file});
}

std::optional<ScreenRequest> Menu::drawEnding(UiContext& context) {
    std::optional<ScreenRequest> asked;
    context.layout.beginCard("ending", text("ending.title"), {.anchor = Anchor::Middle, .width = 440});
    StarCount const stars = context.levels.stars(context.profile.progress());
    caption((stars.missing > 0 ? textWith("ending.stars", stars.won, stars.missing)
                               : textWith("ending.all_stars", stars.won))
                .c_str());
    ImGui::Dummy({0, scaled(2)});
    caption(text("ending.more"));
    ImGui::Dummy({0, scaled(4)});
    if (wide(context, "menu.levels", Icon::List, ButtonLook::Primary)) {
        pages_.push_back(MenuPage::levels);
    }
    if (wide(context, "title.free_play", Icon::Plus)) {
        asked = request::OpenFreePlay{};
    }
    if (wide(context, "menu.title", Icon::Back)) {
        asked = request::ShowTitle{};
        close();
    }
    if (!asked && wide(context, "menu.back", Icon::Cross)) {
        back();
    }
    context.layout.endCard();
    return asked;
}

void Menu::drawSolutions(UiContext& context, Screen& behind) {
    LoadableSolutions* const loadable = behind.loadableSolutions();
    if (loadable == nullptr) {
        return back();
    }
    if (drawn_ != page()) {
        solutions_.open(*loadable);
    }
    switch (solutions_.draw(context, *loadable)) {
    case SolutionsPage::Choice::stay:
        break;
    case SolutionsPage::Choice::back:
        back();
        break;
    case SolutionsPage::Choice::loaded:
        close();
        break;
    }
}

void Menu::drawCommands(UiContext& context, Screen& behind) {
    CommandsPage::Choice const choice = commands_.draw(context, behind.commands());
    if (choice.command) {
        close();
        behind.runNext(*choice.command);
    } else if (choice.changeKeys) {
        pages_.push_back(MenuPage::keys);
    } else if (choice.back) {
        back();
    }
}

std::optional<ScreenRequest> Menu::draw(UiContext& context, Screen& behind) {
    if (keys_.waiting()) { // every key but Esc may be the new one
        keys_.cancelByEscape(context);
    } else if (context.menuKeys.pressed(MenuKey::back) && !solutions_.cancel()) {
        back();
        return {};
    }
    auto const wanted = [&](SDL_Event const& event) {
        auto const chords = context.keys.keysOf("fullscreen");
        return event.type == SDL_KEYDOWN && event.key.repeat == 0 &&
               std::find(chords.begin(), chords.end(), chordOf(event.key.keysym)) != chords.end();
    };
    auto const pressed = context.input.events();
    if (!keys_.waiting() && !solutions_.typing() && !solutions_.browsing() &&
        std::any_of(pressed.begin(), pressed.end(), wanted)) {
        return request::SwitchFullscreen{}; // the one command that a menu has, too
    }
    drawVeil();
    auto const presses = keys_.waiting() || solutions_.typing() ? std::span<MenuKeys::Press const>()
                                                                : context.menuKeys.presses();
    if (page() != MenuPage::solutions || !solutions_.browsing()) { // the list of files is a page of its own
        context.focus.begin(pageName(page()), presses, context.input.mouseMoved() != Point{});
    }
    context.pictures.forgetWaiting();
    MenuPage const shown = page();
    auto asked = drawPage(context, behind);
    drawn_ = shown == page() ? shown : MenuPage::closed;
    return asked;
}

std::optional<ScreenRequest> Menu::drawPage(UiContext& context, Screen& behind) {
    switch (page()) {
    case MenuPage::main:
        return drawMain(context, behind);
    case MenuPage::settings: {
        SettingsPage::Choice const choice = settings_.draw(context);
        if (choice == SettingsPage::Choice::back) {
            back();
        } else if (choice == SettingsPage::Choice::changeKeys) {
            pages_.push_back(MenuPage::keys);
        }
        break;
    }
    case MenuPage::keys:
        if (keys_.draw(context)) {
            back();
        }
        break;
    case MenuPage::levels:
    case MenuPage::gallery:
        return drawLevels(context, behind);
    case MenuPage::ending:
        return drawEnding(context);
    case MenuPage::solutions:
        drawSolutions(context, behind);
        break;
    case MenuPage::commands:
        drawCommands(context, behind);
        break;
    case MenuPage::help: {
        HelpChoice const choice = drawHelp(context, behind);
        if (choice == HelpChoice::back) {
            back();
        } else if (choice == HelpChoice::changeKeys) {
            pages_.push_back(MenuPage::keys);
        }
        break;
    }
    case MenuPage::closed:
        break;
    }
    return {};
}

} // namespace trembler::ui
