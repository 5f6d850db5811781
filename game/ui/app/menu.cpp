#include "game/ui/app/menu.hpp"

#include "audio/device/loudspeaker.hpp"
#include "game/ui/app/level_list.hpp"
#include "game/ui/cards/play_cards.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"

#include <array>
#include <cmath>
#include <string>

namespace trembler::ui {
namespace {

using namespace render;

/// The world steps back behind a sheet of tracing paper.
void drawVeil() {
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, screen, imColour(faded(palette::paper, 0.80F)));
}

// Returns whether something was changed.
bool drawSoundSettings(Layout& layout, Settings& settings) {
    ImGui::TextUnformatted(words::volume);
    ImGui::SetNextItemWidth(-1);
    bool touched = ImGui::SliderInt("##volume", &settings.volume, 0, 100,
                                    settings.volume == 0 ? "off" : "%d %%", ImGuiSliderFlags_AlwaysClamp);
    layout.item("volume");
    touched = ImGui::Checkbox(words::hrtf, &settings.hrtf) || touched;
    layout.item("hrtf");
    ImGui::PushFont(theme().fonts.small);
    caption(words::hrtfTip);
    ImGui::PopFont();
    return touched;
}

bool wide(Layout& layout, char const* label, Icon icon, ButtonLook look = ButtonLook::Quiet) {
    bool const clicked = bigButton(label, {.icon = icon, .look = look, .width = -1});
    layout.item(label);
    return clicked;
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
    page_ = page_ == first_ ? MenuPage::closed : first_;
}

std::optional<MenuChoice> Menu::drawMain(UiContext& context) {
    std::optional<MenuChoice> choice;
    Layout& layout = context.layout;
    layout.beginCard("menu", words::paused, {.anchor = Anchor::Middle, .width = 340});
    ImGui::Dummy({0, scaled(4)});
    if (wide(layout, words::resume, Icon::Play, ButtonLook::Primary)) {
        choice = MenuChoice::resume;
    }
    if (wide(layout, words::restart, Icon::Reset)) {
        choice = MenuChoice::restart;
    }
    if (wide(layout, words::levels, Icon::List)) {
        page_ = MenuPage::levels;
    }
    if (wide(layout, words::settings, Icon::Settings)) {
        page_ = MenuPage::settings;
    }
    if (wide(layout, words::keys, Icon::Why)) {
        page_ = MenuPage::help;
    }
    if (wide(layout, words::toTitle, Icon::Back)) {
        choice = MenuChoice::toTitle;
    }
    if (wide(layout, words::quit, Icon::Cross)) {
        choice = MenuChoice::quit;
    }
    layout.endCard();
    return choice;
}

void Menu::drawSettings(UiContext& context) {
    Settings changed = context.profile.settings();
    Layout& layout = context.layout;
    layout.beginCard("settings", words::settings, {.anchor = Anchor::Middle, .width = 440});
    ImGui::Dummy({0, scaled(2)});
    ImGui::TextUnformatted(words::uiSize);
    // Steps, not a slider: a slider that changes its own size while it is dragged runs away from the mouse.
    constexpr std::array steps{0.75F, 0.9F, 1.F, 1.15F, 1.35F, 1.6F};
    bool touched = false;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (i > 0) {
            ImGui::SameLine(0, scaled(6));
        }
        bool const on = std::abs(changed.uiScale - steps[i]) < 0.01F;
        std::string const label = std::to_string(static_cast<int>(std::lround(steps[i] * 100))) + "%";
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(scaled(7), scaled(7)));
        if (on) {
            ImGui::PushStyleColor(ImGuiCol_Button, imColour4(palette::accent));
            ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::paperLight));
        }
        if (ImGui::Button(label.c_str())) {
            changed.uiScale = steps[i];
            touched = true;
        }
        layout.item(label);
        if (on) {
            ImGui::PopStyleColor(2);
        }
        ImGui::PopStyleVar();
    }
    ImGui::Dummy({0, scaled(4)});
    bool shadows = context.shadows;
    if (ImGui::Checkbox(words::shadows, &shadows)) {
        changed.shadows = shadows;
        touched = true;
    }
    layout.item("shadows");
    ImGui::PushFont(theme().fonts.small);
    caption(words::shadowsTip);
    ImGui::PopFont();
    touched = drawSoundSettings(layout, changed) || touched;
    if (ImGui::Checkbox(words::fullscreen, &changed.fullscreen)) {
        touched = true;
    }
    ImGui::Dummy({0, scaled(4)});
    if (wide(layout, words::back, Icon::Back)) {
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

std::optional<MenuChoice> Menu::draw(UiContext& context, std::filesystem::path const& playing,
                                     CatalogEntry const*& level) {
    drawVeil();
    switch (page_) {
    case MenuPage::main:
        return drawMain(context);
    case MenuPage::settings:
        drawSettings(context);
        break;
    case MenuPage::levels: {
        context.layout.beginCard("level list", words::levelList, {.anchor = Anchor::Middle, .width = 480});
        level = drawLevelList(context, playing, 440);
        ImGui::Dummy({0, scaled(4)});
        if (wide(context.layout, words::back, Icon::Back)) {
            back();
        }
        context.layout.endCard();
        break;
    }
    case MenuPage::help: {
        bool stays = true;
        drawHelp(context.layout, stays);
        if (!stays) {
            back();
        }
        break;
    }
    case MenuPage::closed:
        break;
    }
    return {};
}

} // namespace trembler::ui
