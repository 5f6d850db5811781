#include "game/ui/app/menu.hpp"

#include "audio/device/loudspeaker.hpp"
#include "game/ui/app/help_page.hpp"
#include "game/ui/app/level_list.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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
    case MenuPage::help:
        return "help";
    case MenuPage::closed:
        break;
    }
    return "";
}

/// Returns whether it was changed.
bool check(UiContext& context, char const* label, char const* item, bool& value) {
    bool touched = ImGui::Checkbox(label, &value);
    context.layout.item(item);
    if (context.focus.item()) {
        value = !value;
        touched = true;
    }
    return touched;
}

void smallCaption(char const* text) {
    ImGui::PushFont(theme().fonts.small);
    caption(text);
    ImGui::PopFont();
}

// Returns whether something was changed.
bool drawSoundSettings(UiContext& context, Settings& settings) {
    ImGui::TextUnformatted(words::volume);
    ImGui::SetNextItemWidth(-1);
    bool touched = ImGui::SliderInt("##volume", &settings.volume, 0, 100,
                                    settings.volume == 0 ? "off" : "%d %%", ImGuiSliderFlags_AlwaysClamp);
    context.layout.item("volume");
    context.focus.item(true);
    if (int const steps = context.focus.adjusted(); steps != 0) {
        settings.volume = std::clamp(settings.volume + 5 * steps, 0, 100);
        touched = true;
    }
    touched = check(context, words::hrtf, "hrtf", settings.hrtf) || touched;
    smallCaption(words::hrtfTip);
    return touched;
}

// Buttons for steps, not a slider: a slider that changes its own size while it is dragged runs away from the
// mouse.
bool drawSizes(UiContext& context, Settings& settings) {
    constexpr std::array steps{0.75F, 0.9F, 1.F, 1.15F, 1.35F, 1.6F};
    bool touched = false;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (i > 0) {
            ImGui::SameLine(0, scaled(6));
        }
        bool const on = std::abs(settings.uiScale - steps[i]) < 0.01F;
        std::string const label = std::to_string(static_cast<int>(std::lround(steps[i] * 100))) + "%";
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(scaled(7), scaled(7)));
        if (on) {
            ImGui::PushStyleColor(ImGuiCol_Button, imColour4(palette::accent));
            ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::paperLight));
        }
        bool chosen = ImGui::Button(label.c_str());
        context.layout.item(label);
        chosen = context.focus.item() || chosen;
        if (on) {
            ImGui::PopStyleColor(2);
        }
        ImGui::PopStyleVar();
        if (chosen) {
            settings.uiScale = steps[i];
            touched = true;
        }
    }
    return touched;
}

/// A button as wide as the card, or `width` pixels at UI scale 1 wide.
bool wide(UiContext& context, char const* label, Icon icon, ButtonLook look = ButtonLook::Quiet,
          float width = -1) {
    bool const clicked = bigButton(label, {.icon = icon, .look = look, .width = width});
    context.layout.item(label);
    return context.focus.item() || clicked;
}

} // namespace

void applySettings(UiContext& context) {
    Settings const& settings = context.profile.settings();
    context.window.setUiScaleRequest(settings.uiScale);
    context.window.setFullscreen(settings.fullscreen);
    if (context.loudspeaker != nullptr) {
        context.loudspeaker->set({.volume = settings.volume / 100.0, .hrtf = settings.hrtf});
    }
    context.shadows = settings.shadows && (context.profile.stated() || !context.window.software());
}

void Menu::back() {
    keys_.cancel();
    if (!pages_.empty()) {
        pages_.pop_back();
    }
}

std::optional<ScreenRequest> Menu::drawMain(UiContext& context, Screen& behind) {
    std::optional<ScreenRequest> asked;
    Layout& layout = context.layout;
    layout.beginCard("menu", words::paused, {.anchor = Anchor::Middle, .width = 340});
    ImGui::Dummy({0, scaled(4)});
    bool const resume = wide(context, words::resume, Icon::Play, ButtonLook::Primary);
    bool const restart = behind.commands().has("restart") && wide(context, words::restart, Icon::Reset);
    if (wide(context, words::levels, Icon::List)) {
        pages_.push_back(MenuPage::levels);
    }
    if (wide(context, words::settings, Icon::Settings)) {
        pages_.push_back(MenuPage::settings);
    }
    if (wide(context, words::keys, Icon::Why)) {
        pages_.push_back(MenuPage::help);
    }
    if (wide(context, words::toTitle, Icon::Back)) {
        asked = request::ShowTitle{};
    }
    if (wide(context, words::quit, Icon::Cross)) {
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

void Menu::drawSettings(UiContext& context) {
    Settings changed = context.profile.settings();
    Layout& layout = context.layout;
    layout.beginCard("settings", words::settings, {.anchor = Anchor::Middle, .width = 440});
    ImGui::Dummy({0, scaled(2)});
    ImGui::TextUnformatted(words::uiSize);
    bool touched = drawSizes(context, changed);
    ImGui::Dummy({0, scaled(4)});
    bool shadows = context.shadows;
    if (check(context, words::shadows, "shadows", shadows)) {
        changed.shadows = shadows;
        touched = true;
    }
    smallCaption(words::shadowsTip);
    touched = drawSoundSettings(context, changed) || touched;
    std::string const fullscreen = withKey(words::fullscreen, "fullscreen", context.keys);
    touched = check(context, fullscreen.c_str(), "fullscreen", changed.fullscreen) || touched;
    ImGui::Dummy({0, scaled(4)});
    float const half = (ImGui::GetContentRegionAvail().x - scaled(8)) / 2 / theme().scale;
    if (wide(context, words::changeKeys, Icon::Why, ButtonLook::Quiet, half)) {
        pages_.push_back(MenuPage::keys);
    }
    ImGui::SameLine(0, scaled(8));
    if (wide(context, words::back, Icon::Back, ButtonLook::Quiet, half)) {
        back();
    }
    layout.endCard();
    if (touched) {
        bool const asRequested = changed.shadows;
        context.profile.setSettings(changed);
        applySettings(context);
        context.shadows = asRequested;
    }
}

std::optional<ScreenRequest> Menu::drawLevels(UiContext& context, Screen& behind) {
    context.layout.beginCard("level list", words::levelList, {.anchor = Anchor::Middle, .width = 480});
    CatalogEntry const* const level = drawLevelList(context, behind.level(), 440);
    ImGui::Dummy({0, scaled(4)});
    if (wide(context, words::back, Icon::Back)) {
        back();
    }
    context.layout.endCard();
    return level == nullptr ? std::nullopt : std::optional<ScreenRequest>(request::OpenLevel{level->file});
}

std::optional<ScreenRequest> Menu::draw(UiContext& context, Screen& behind) {
    if (context.input.keyPressed(SDLK_ESCAPE) && !keys_.cancel()) {
        back();
        return {};
    }
    drawVeil();
    auto const events = keys_.waiting() ? std::span<SDL_Event const>() : context.input.events();
    context.focus.begin(pageName(page()), events, context.input.mouseMoved() != Point{});
    switch (page()) {
    case MenuPage::main:
        return drawMain(context, behind);
    case MenuPage::settings:
        drawSettings(context);
        break;
    case MenuPage::keys:
        if (keys_.draw(context)) {
            back();
        }
        break;
    case MenuPage::levels:
        return drawLevels(context, behind);
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
