#include "game/ui/cards/celebration.hpp"
#include "game/ui/cards/play_cards.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace trembler::ui {
namespace {

using namespace render;

/// Uniform pseudo-random numbers from 0 to 1, the same in every run.
float scatter(int index, int which) {
    auto mixed = static_cast<unsigned>(index) * 2654435761U + static_cast<unsigned>(which) * 40503U;
    mixed ^= mixed >> 15U;
    mixed *= 2246822519U;
    mixed ^= mixed >> 13U;
    return static_cast<float>(mixed & 0xffffU) / 65535.F;
}

/// Snippets of coloured paper that fall behind the card, right of `left`, for a few seconds.
void drawConfetti(double age, float left) {
    constexpr int pieces = 48;
    constexpr double life = 4.5;
    if (age > life) {
        return;
    }
    std::array const colours{palette::accent, palette::goal, palette::live, palette::northPole,
                             palette::force};
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    auto& list = *ImGui::GetBackgroundDrawList();
    auto const t = static_cast<float>(age);
    for (int i = 0; i < pieces; ++i) {
        float const start = 0.7F * scatter(i, 0);
        float const own = t - start;
        if (own < 0) {
            continue;
        }
        float const drift =
            scaled(60) * (scatter(i, 1) - 0.5F) + scaled(16) * std::sin(3 * own + 6 * scatter(i, 2));
        ImVec2 const at{left + (screen.x - left) * scatter(i, 3) + drift,
                        -scaled(20) + own * scaled(150 + 160 * scatter(i, 4)) + own * own * scaled(22)};
        float const turn = 5 * own * (scatter(i, 5) - 0.5F) + 6.28F * scatter(i, 6);
        float const flat = std::abs(std::cos(4 * own + 6 * scatter(i, 7)));
        float const half = scaled(4 + 4 * scatter(i, 8));
        ImVec2 const x{half * std::cos(turn), half * std::sin(turn)};
        ImVec2 const y{-0.6F * flat * x.y, 0.6F * flat * x.x};
        auto const fade = static_cast<float>(std::clamp((life - age) / 1.2, 0.0, 1.0));
        list.AddQuadFilled(
            {at.x - x.x - y.x, at.y - x.y - y.y}, {at.x + x.x - y.x, at.y + x.y - y.y},
            {at.x + x.x + y.x, at.y + x.y + y.y}, {at.x - x.x + y.x, at.y - x.y + y.y},
            imColour(faded(colours[static_cast<std::size_t>(i) % colours.size()], 0.85F * fade)));
    }
}

/// A round stamp with a tick, pressed on with a small bounce; `age` in s, infinity: at rest.
void drawSeal(ImVec2 centre, float radius, double age) {
    auto const t = static_cast<float>(std::min(age / 0.35, 1.0));
    float const grown = radius * (1 + 0.9F * (1 - t) * (1 - t));
    // Drawn outside the card, because the seal is larger than the card while it falls.
    auto& list = *ImGui::GetForegroundDrawList();
    float const seen = std::min(1.F, 2 * t);
    list.AddCircleFilled(centre, grown, imColour(faded(palette::goal, seen)));
    list.AddCircle(centre, grown * 0.84F, imColour(faded(palette::paperLight, 0.7F * seen)), 0, scaled(1.6F));
    drawIcon(list, Icon::Tick, centre, grown * 0.95F, imColour(faded(palette::paperLight, seen)));
}

} // namespace

void drawSuccess(CommandButtons& buttons, Session const& session, Celebration const& celebration,
                 SuccessLook const& look) {
    if (!celebration.showing()) {
        return;
    }
    Layout& layout = buttons.layout();
    float const width = toolboxWidth(ImGui::GetIO().DisplaySize.x / theme().scale, hasLargeToolbox(session));
    if (look.moving) {
        drawConfetti(celebration.age(), ImGui::GetIO().DisplaySize.x - scaled(width + 2 * cardGap));
    }
    // In a run the toolbox leaves its place, where nothing of the machine lies.
    layout.beginCard("success", "",
                     {.anchor = Anchor::TopRight, .offset = {cardGap, cornerRow}, .width = width});
    float const seal = scaled(std::min(30.F, 0.12F * width)); // so that the words fit beside it
    ImVec2 const at = ImGui::GetCursorScreenPos();
    if (layout.card("success")) { // never alone: the card is not seen before its size is known
        drawSeal({at.x + seal, at.y + seal}, seal,
                 look.moving ? celebration.age() : std::numeric_limits<double>::infinity());
    }
    ImGui::SetCursorScreenPos({at.x + 2 * seal + scaled(12), at.y - scaled(2)});
    ImGui::BeginGroup();
    ImGui::PushFont(theme().fonts.heading);
    ImGui::TextUnformatted(words::solved);
    ImGui::PopFont();
    if (look.last) {
        caption(words::lastLevel);
    }
    ImGui::EndGroup();
    ImGui::SetCursorScreenPos({at.x, std::max(ImGui::GetItemRectMax().y, at.y + 2 * seal) + scaled(12)});
    caption(words::solvedWith(celebration.solvedAt().value_or(0), static_cast<int>(session.placed().size()))
                .c_str());
    buttons.big("next-level",
                {.label = look.next, .look = ButtonLook::Primary, .width = -1, .withTip = false});
    buttons.big("watch-again", {.width = -1, .withTip = false});
    buttons.big("keep-playing", {.width = -1, .withTip = false});
    layout.endCard();
}

} // namespace trembler::ui
