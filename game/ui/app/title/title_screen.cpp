#include "game/ui/app/title/title_screen.hpp"

#include "game/ui/app/title/title_picture.hpp"
#include "game/ui/shared/commands/carry_out_keys.hpp"
#include "game/ui/shared/commands/common_commands.hpp"
#include "game/ui/shared/texts.hpp"
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
    {.info = common::help, .run = [](TitleScreen& title) { title.ask(request::OpenMenu{MenuPage::help}); }},
};

// Pixels at UI scale 1.
constexpr float usualButtonsWidth = 300;
constexpr float columnsWidth = 400; ///< of two columns of buttons
constexpr float titleMargin = 40;
/// Height below which the buttons stand in two columns, pixels at UI scale 1.
constexpr float roomForOneColumn = 520;
/// Width of the card with the buttons, pixels at UI scale 1.
float buttonsWidth() {
    return ImGui::GetIO().DisplaySize.y / theme().scale < roomForOneColumn ? columnsWidth : usualButtonsWidth;
}

/// How often the bell rings after the title has appeared or the mouse has touched it.
constexpr double ringingFor = 2 * titlePeriod; // s

} // namespace

std::span<Command<TitleScreen> const> titleCommands() {
    return titleTable;
}

void TitleScreen::drawTitle() {
    Layout& layout = context_.layout;
    float const screen = ImGui::GetIO().DisplaySize.x / theme().scale;
    float const width = std::min(screen - buttonsWidth() - 3 * titleMargin, 520.F);
    layout.beginCard(
        "title", "",
        {.anchor = Anchor::TopLeft, .offset = {titleMargin, titleMargin}, .width = width, .bare = true});
    ImGui::PushFont(theme().fonts.title);
    ImGui::TextUnformatted(words::programName);
    ImGui::PopFont();
    ImVec2 const low = ImGui::GetItemRectMin();
    float const y = ImGui::GetItemRectMax().y + scaled(2);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x + scaled(2), y}, {low.x + scaled(74), y + scaled(5)},
                                              imColour(palette::accent), scaled(2.5F));
    ImGui::Dummy({0, scaled(10)});
    caption(text("title.tagline"));
    layout.endCard();
}

bool TitleScreen::drawButton(char const* label, char const* item, Icon icon, ButtonLook look, float width) {
    bool const clicked = bigButton(label, {.icon = icon, .look = look, .width = width});
    context_.layout.item(item);
    return context_.focus.item() || clicked;
}

void TitleScreen::drawButtons() {
    Layout& layout = context_.layout;
    float const screen = ImGui::GetIO().DisplaySize.y / theme().scale;
    bool const narrow = screen < roomForOneColumn;
    layout.beginCard("title buttons", "",
                     {.anchor = Anchor::Right, .offset = {titleMargin, 0}, .width = buttonsWidth()});
    CampaignProgress const& progress = context_.profile.progress();
    CatalogEntry const* const next = context_.levels.next(progress);
    if (next != nullptr) {
        char const* const label = progress.empty() ? text("title.play") : text("title.continue");
        if (drawButton(label, "play", Icon::Play, ButtonLook::Primary, -1)) {
            ask(request::OpenLevel{next->file});
        }
        smallCaption(titleIn(next->texts, std::string(languageInUse()), next->title).c_str());
    }
    float const half = (ImGui::GetContentRegionAvail().x - scaled(8)) / 2 / theme().scale;
    bool left = true;
    auto const button = [&](char const* label, char const* item, Icon icon) {
        if (narrow && !left) {
            ImGui::SameLine(0, scaled(8));
        }
        left = !left;
        return drawButton(label, item, icon, ButtonLook::Quiet, narrow ? half : -1);
    };
    auto const& chapters = context_.levels.groups();
    if (button(text("title.levels"), "levels", Icon::List)) {
        ask(request::OpenMenu{MenuPage::levels});
    }
    if (std::any_of(chapters.begin(), chapters.end(), [](CatalogGroup const& one) { return one.gallery; }) &&
        button(text("title.gallery"), "gallery", Icon::Eye)) {
        ask(request::OpenMenu{MenuPage::gallery});
    }
    if (button(text("title.free_play"), "free play", Icon::Plus)) {
        ask(request::OpenFreePlay{});
    }
    if (button(text("title.editor"), "editor", Icon::Plus)) {
        ask(request::OpenEditor{});
    }
    if (button(text("menu.settings"), "settings", Icon::Settings)) {
        ask(request::OpenMenu{MenuPage::settings});
    }
    if (button(text("menu.keys"), "keys", Icon::Why)) {
        ask(request::OpenMenu{MenuPage::help});
    }
    if (button(text("menu.quit"), "quit", Icon::Cross)) {
        ask(request::Quit{});
    }
    layout.endCard();
}

void TitleScreen::pass(double seconds) {
    if (context_.profile.settings().reducedMotion) {
        rings_ = 0;
    } else if (rings_ > 0) {
        rings_ -= std::clamp(seconds, 0.0, 0.1);
    }
    rings_ = std::max(rings_, 0.0);
}

bool TitleScreen::still() const {
    return rings_ <= 0;
}

void TitleScreen::updateBehindMenu(double) {}

std::optional<ScreenRequest> TitleScreen::update(double seconds) {
    pass(seconds);
    request_.reset();
    carryOutKeys(context_.input.events(), context_.keys, commands_);
    context_.focus.begin("title", context_.menuKeys.presses(), context_.input.mouseMoved() != Point{});
    drawTitle();
    drawButtons();
    if (context_.input.pressed(MouseButton::Left) && !context_.gui.wantsMouse() && rings_ <= 0) {
        rings_ = ringingFor; // a click on the background rings the bell of the picture
    }
    return request_;
}

void TitleScreen::draw() {
    Canvas& canvas = context_.canvas;
    Size const size = context_.window.size();
    auto const scale = static_cast<double>(context_.window.uiScale());
    Camera camera;
    camera.viewport = size;
    // The picture fills the space beside the title and the buttons.
    auto const title = context_.layout.card("title");
    double const left = 24 * scale;
    double const right = size.width - static_cast<double>(buttonsWidth() + 2 * titleMargin) * scale;
    double const top = (title ? title->high.y : 210 * scale) + 16 * scale;
    double const bottom = size.height - 24 * scale;
    camera.pixelsPerMetre =
        std::max(std::min((right - left) / titleWidth, (bottom - top) / titleHeight), 1.0);
    camera.centre = {(0.5 * size.width - 0.5 * (left + right)) / camera.pixelsPerMetre,
                     (0.5 * (top + bottom) - 0.5 * size.height) / camera.pixelsPerMetre};
    canvas.begin(camera, {.uiScale = context_.window.uiScale(), .time = 0, .shadows = context_.shadows});
    canvas.paper();
    drawTrembler(canvas, rings_ > 0 ? ringingFor - rings_ : titleAtRest);
    canvas.end();
}

} // namespace trembler::ui
