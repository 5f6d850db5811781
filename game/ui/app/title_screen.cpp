#include "game/ui/app/title_screen.hpp"

#include "game/ui/app/level_list.hpp"
#include "game/ui/app/title_picture.hpp"
#include "game/ui/commands/carry_out_keys.hpp"
#include "game/ui/commands/common_commands.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>

namespace trembler::ui {

using namespace render;

namespace {

constexpr Command<TitleScreen> titleTable[] = {
    {.info = common::fullscreen, .run = [](TitleScreen& title) { title.ask(request::SwitchFullscreen{}); }},
};

} // namespace

std::span<Command<TitleScreen> const> titleCommands() {
    return titleTable;
}

void TitleScreen::drawTitle() {
    Layout& layout = context_.layout;
    layout.beginCard("title", "",
                     {.anchor = Anchor::TopLeft, .offset = {64, 56}, .width = 520, .bare = true});
    ImGui::PushFont(theme().fonts.title);
    ImGui::TextUnformatted(words::programName);
    ImGui::PopFont();
    ImVec2 const low = ImGui::GetItemRectMin();
    float const y = ImGui::GetItemRectMax().y + scaled(2);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x + scaled(2), y}, {low.x + scaled(74), y + scaled(5)},
                                              imColour(palette::accent), scaled(2.5F));
    ImGui::Dummy({0, scaled(10)});
    caption(words::tagline);
    layout.endCard();
}

void TitleScreen::drawButtons() {
    Layout& layout = context_.layout;
    layout.beginCard("title buttons", "", {.anchor = Anchor::BottomLeft, .offset = {64, 48}, .bare = true});
    bool const editor = bigButton(words::openEditor, {.icon = Icon::Plus});
    layout.item("editor");
    if (context_.focus.item() || editor) {
        ask(request::OpenEditor{});
    }
    ImGui::SameLine(0, scaled(10));
    bool const settings = bigButton(words::settings, {.icon = Icon::Settings});
    layout.item("settings");
    if (context_.focus.item() || settings) {
        ask(request::OpenMenu{MenuPage::settings});
    }
    ImGui::SameLine(0, scaled(10));
    bool const quit = bigButton(words::quit, {.icon = Icon::Cross});
    layout.item("quit");
    if (context_.focus.item() || quit) {
        ask(request::Quit{});
    }
    layout.endCard();
}

void TitleScreen::updateBehindMenu(double seconds) {
    time_ += std::clamp(seconds, 0.0, 0.1);
}

std::optional<ScreenRequest> TitleScreen::update(double seconds) {
    time_ += std::clamp(seconds, 0.0, 0.1);
    request_.reset();
    carryOutKeys(context_.input.events(), context_.keys, commands_);
    context_.focus.begin("title", context_.input.events(), context_.input.mouseMoved() != Point{});
    drawTitle();
    Layout& layout = context_.layout;
    float const screen = ImGui::GetIO().DisplaySize.y / theme().scale;
    layout.beginCard("title levels", words::levels,
                     {.anchor = Anchor::Right, .offset = {56, 0}, .width = 430});
    if (CatalogEntry const* const level = drawLevelList(context_, {}, screen - 190)) {
        ask(request::OpenLevel{level->file});
    }
    layout.endCard();
    drawButtons();
    return request_;
}

void TitleScreen::draw() {
    Canvas& canvas = context_.canvas;
    Size const size = context_.window.size();
    auto const scale = static_cast<double>(context_.window.uiScale());
    Camera camera;
    camera.viewport = size;
    // The picture fills what the title, the buttons and the list of levels leave free.
    double const left = 40 * scale;
    double const right = size.width - 530 * scale;
    double const top = 210 * scale;
    double const bottom = size.height - 120 * scale;
    camera.pixelsPerMetre =
        std::max(std::min((right - left) / titleWidth, (bottom - top) / titleHeight), 1.0);
    camera.centre = {(0.5 * size.width - 0.5 * (left + right)) / camera.pixelsPerMetre,
                     (0.5 * (top + bottom) - 0.5 * size.height) / camera.pixelsPerMetre};
    canvas.begin(camera, {.uiScale = context_.window.uiScale(), .time = time_, .shadows = context_.shadows});
    canvas.paper();
    drawTrembler(canvas, time_);
    canvas.end();
}

} // namespace trembler::ui
