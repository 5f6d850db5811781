#include "game/ui/app/menu/settings_page.hpp"

#include "audio/device/loudspeaker.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace trembler::ui {
namespace {

using namespace render;

/// Returns whether it was changed.
bool check(UiContext& context, char const* label, char const* item, bool& value) {
    bool touched = checkBox(label, &value);
    context.layout.item(item);
    if (context.focus.item()) {
        value = !value;
        touched = true;
    }
    return touched;
}

/// A slider of percent; above it its name, and the number, which the knob would cover.
bool drawVolume(UiContext& context, char const* label, char const* item, int& value) {
    ImGui::TextUnformatted(label);
    std::string const number = value == 0 ? text("settings.off") : std::to_string(value) + " %";
    float const width = ImGui::CalcTextSize(number.c_str()).x;
    ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width);
    ImGui::TextUnformatted(number.c_str());
    ImGui::SetNextItemWidth(-1);
    bool touched = ImGui::SliderInt((std::string("##") + item).c_str(), &value, 0, 100, "",
                                    ImGuiSliderFlags_AlwaysClamp);
    context.layout.item(item);
    context.focus.item(true);
    if (int const steps = context.focus.adjusted(); steps != 0) {
        value = std::clamp(value + 5 * steps, 0, 100);
        touched = true;
    }
    return touched;
}

constexpr float choicePadding = 7; // above and below the words of a button

/// One of several buttons in a row, of which one is on. Returns whether it was chosen.
bool choiceButton(UiContext& context, char const* label, char const* item, bool on, bool first) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(scaled(7), scaled(choicePadding)));
    if (!first) {
        ImGui::SameLine(0, scaled(6));
    }
    if (on) {
        ImGui::PushStyleColor(ImGuiCol_Button, imColour4(palette::accent));
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, imColour4(palette::accent));
        ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::paperLight));
    }
    bool const clicked = ImGui::Button(label);
    context.layout.item(item);
    bool const chosen = context.focus.item() || clicked;
    if (on) {
        ImGui::PopStyleColor(3);
    }
    ImGui::PopStyleVar();
    return chosen;
}

// Buttons for steps, not a slider: a slider that changes its own size while it is dragged runs away from the
// mouse.
bool drawSizes(UiContext& context, Settings& settings) {
    constexpr std::array steps{0.75F, 0.9F, 1.F, 1.15F, 1.35F, 1.6F};
    bool touched = false;
    ImGui::TextUnformatted(text("settings.size"));
    for (std::size_t i = 0; i < steps.size(); ++i) {
        bool const on = std::abs(settings.uiScale - steps[i]) < 0.01F;
        std::string const percent = std::to_string(static_cast<int>(std::lround(steps[i] * 100)));
        if (choiceButton(context, (percent + " %").c_str(), (percent + "%").c_str(), on, i == 0)) {
            settings.uiScale = steps[i];
            touched = true;
        }
    }
    return touched;
}

bool drawLanguages(UiContext& context, Settings& settings) {
    bool touched = false;
    ImGui::TextUnformatted(text("settings.language"));
    for (std::size_t i = 0; i < languages().size(); ++i) {
        Language const& language = languages()[i];
        std::string const item = "language " + std::string(language.id);
        if (choiceButton(context, std::string(language.name).c_str(), item.c_str(),
                         language.id == languageInUse(), i == 0)) {
            settings.language = language.id;
            touched = true;
        }
    }
    return touched;
}

bool drawColours(UiContext& context, Settings& settings) {
    ImGui::TextUnformatted(text("settings.colours"));
    bool const before = settings.clearColours;
    if (choiceButton(context, text("settings.colours_usual"), "usual colours", !before, true)) {
        settings.clearColours = false;
    }
    if (choiceButton(context, text("settings.colours_clear"), "clear colours", before, false)) {
        settings.clearColours = true;
    }
    return settings.clearColours != before;
}

/// Returns whether something was changed.
bool drawRows(UiContext& context, Settings& settings) {
    bool touched = drawSizes(context, settings);
    // In one row, so that the page fits into a window of the usual size.
    float const top = ImGui::GetCursorPosY();
    ImGui::BeginGroup();
    touched = drawLanguages(context, settings) || touched;
    ImGui::EndGroup();
    ImGui::SameLine(0, scaled(18));
    ImGui::SetCursorPosY(top -
                         scaled(choicePadding)); // ImGui moves words to the middle of buttons in their row
    ImGui::BeginGroup();
    touched = drawColours(context, settings) || touched;
    ImGui::EndGroup();
    touched = drawVolume(context, text("settings.volume"), "volume", settings.volume) || touched;
    touched = drawVolume(context, text("settings.touches"), "interface volume", settings.touches) || touched;
    touched = check(context, text("settings.hrtf"), "hrtf", settings.hrtf) || touched;
    smallCaption(text("settings.hrtf_tip"));
    // Without a graphics card shadows are off until the player switches them on.
    bool shadows = context.shadows;
    if (check(context, text("settings.shadows"), "shadows", shadows)) {
        settings.shadows = shadows;
        settings.shadowsChosen = true;
        touched = true;
    }
    smallCaption(text("settings.shadows_tip"));
    touched = check(context, text("settings.motion"), "reduced motion", settings.reducedMotion) || touched;
    smallCaption(text("settings.motion_tip"));
    touched = check(context, text("settings.pad_second"), "pad is second", settings.padIsSecond) || touched;
    std::string const fullscreen = withKey(text("settings.fullscreen"), "fullscreen", context.keys);
    return check(context, fullscreen.c_str(), "fullscreen", settings.fullscreen) || touched;
}

} // namespace

void applySettings(UiContext& context) {
    Settings const& settings = context.profile.settings();
    context.window.setUiScaleRequest(settings.uiScale);
    context.window.setFullscreen(settings.fullscreen);
    if (context.loudspeaker != nullptr) {
        context.loudspeaker->set(
            {.volume = settings.volume / 100.0, .touches = settings.touches / 100.0, .hrtf = settings.hrtf});
    }
    context.shadows = settings.shadows && (settings.shadowsChosen || !context.window.software());
    useLanguage(settings.language);
    palette::use(settings.clearColours ? palette::Choice::clear : palette::Choice::usual);
}

void changeSettings(UiContext& context, Settings const& settings) {
    context.profile.setSettings(settings);
    applySettings(context);
}

SettingsPage::Choice SettingsPage::draw(UiContext& context) {
    Settings changed = context.profile.settings();
    Choice choice = Choice::stay;
    Layout& layout = context.layout;
    layout.beginCard("settings", text("settings.title"), {.anchor = Anchor::Middle, .width = 460});
    // With large letters on a small window the rows scroll.
    float const room = ImGui::GetIO().DisplaySize.y - scaled(160);
    bool const scrolls = rows_ > room;
    if (scrolls) {
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::BeginChild("rows", {0, room});
    }
    float const top = ImGui::GetCursorPosY();
    bool const touched = drawRows(context, changed);
    rows_ = ImGui::GetCursorPosY() - top;
    if (scrolls) {
        ImGui::EndChild();
        ImGui::PopStyleColor();
    }
    ImGui::Dummy({0, scaled(2)});
    float const half = (ImGui::GetContentRegionAvail().x - scaled(8)) / 2 / theme().scale;
    bool const keys = bigButton(text("keys.change"), {.icon = Icon::Why, .width = half});
    layout.item("Change the keys");
    if (context.focus.item() || keys) {
        choice = Choice::changeKeys;
    }
    ImGui::SameLine(0, scaled(8));
    bool const back = bigButton(text("menu.back"), {.icon = Icon::Back, .width = half});
    layout.item("Back");
    if (context.focus.item() || back) {
        choice = Choice::back;
    }
    layout.endCard();
    if (touched) {
        changeSettings(context, changed);
    }
    return choice;
}

} // namespace trembler::ui
