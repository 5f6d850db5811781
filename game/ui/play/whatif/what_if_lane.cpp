#include "game/ui/play/whatif/what_if_lane.hpp"

#include "game/ui/play/timeline/timeline_bar.hpp"
#include "game/ui/play/whatif/what_if_colour.hpp"
#include "game/ui/shared/card_sizes.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

using namespace render;

// Pixels at UI scale 1.
constexpr float laneKnob = 6.5F; ///< as the knob of the track below
constexpr float laneTick = 12;

} // namespace

std::optional<std::uint64_t> drawWhatIfLane(CommandButtons& buttons, Timeline const& timeline,
                                            WhatIfView const& view) {
    Layout& layout = buttons.layout();
    float const width = ImGui::GetIO().DisplaySize.x / theme().scale - 2 * cardGap;
    layout.beginCard("what if lane", "",
                     {.anchor = Anchor::BottomLeft,
                      .offset = {cardGap, bottomRow + timelineRow},
                      .width = width,
                      .bare = true});
    ImVec2 const origin = ImGui::GetCursorScreenPos();
    float const height = scaled(whatIfLane - 6);
    ImGui::InvisibleButton("lane", {scaled(width), height});
    layout.item("what if lane track");
    bool const held = ImGui::IsItemActive();
    auto& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(origin, {origin.x + scaled(width), origin.y + height},
                       imColour(faded(palette::paperLight, 0.94F)), scaled(9));
    list.AddRect(origin, {origin.x + scaled(width), origin.y + height}, imColour(whatIfColour()), scaled(9),
                 0, scaled(1.5F));
    float const low = origin.x + scaled(trackFromLeft + laneKnob + 5);
    float const high = origin.x + scaled(width - trackFromRight - laneKnob - 5);
    float const middle = origin.y + 0.5F * height;
    std::uint64_t const last = timeline.last();
    auto const x = [&](std::uint64_t frame) {
        float const share = last == 0 ? 0.F : static_cast<float>(frame) / static_cast<float>(last);
        return low + std::min(share, 1.F) * (high - low);
    };
    list.AddLine({low, middle}, {x(view.moment()), middle}, imColour(palette::paperShade), scaled(3));
    ImU32 const colour = imColour(whatIfColour());
    if (insight::OtherRun const* const run = view.run()) {
        std::uint64_t const known = std::max(run->frame(), view.moment());
        list.AddLine({x(view.moment()), middle}, {x(known), middle}, imColour(faded(whatIfColour(), 0.45F)),
                     scaled(4));
        if (auto const differs = run->firstDifference()) {
            list.AddLine({x(*differs), middle}, {x(known), middle}, colour, scaled(4));
            ImVec2 const at{x(*differs), middle};
            float const r = scaled(5);
            list.AddQuadFilled({at.x - r, at.y}, {at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r},
                               colour);
        }
        for (GoalStatus const& goal : run->goals()) {
            if (goal.frame && *goal.frame > view.moment()) {
                drawIcon(list, Icon::Tick, {x(*goal.frame), middle}, scaled(laneTick),
                         imColour(palette::goal));
            }
        }
    }
    list.AddLine({x(view.moment()), origin.y + scaled(3)}, {x(view.moment()), origin.y + height - scaled(3)},
                 colour, scaled(2.5F));
    list.AddLine({x(timeline.frame()), origin.y}, {x(timeline.frame()), origin.y + height},
                 imColour(faded(palette::accentDeep, 0.6F)), scaled(1.5F));
    ImGui::PushFont(theme().fonts.strong);
    list.AddText({origin.x + scaled(10), middle - 0.5F * ImGui::GetTextLineHeight()}, colour,
                 text("What if"));
    ImGui::PopFont();
    ImGui::PushFont(theme().fonts.strong);
    std::string const badge = text("does not count");
    ImVec2 const words = ImGui::CalcTextSize(badge.c_str());
    ImVec2 const at{high + scaled(laneKnob + 18), middle - 0.5F * words.y};
    list.AddRectFilled({at.x - scaled(9), origin.y + scaled(3)},
                       {at.x + words.x + scaled(9), origin.y + height - scaled(3)}, colour, scaled(8));
    list.AddText(at, imColour(palette::paperLight), badge.c_str());
    ImGui::PopFont();
    layout.endCard();
    if (!held || high <= low) {
        return std::nullopt;
    }
    float const share = std::clamp((ImGui::GetIO().MousePos.x - low) / (high - low), 0.F, 1.F);
    auto const wanted = static_cast<std::uint64_t>(std::lround(share * static_cast<float>(last)));
    return wanted != timeline.frame() ? std::optional(wanted) : std::nullopt;
}

} // namespace trembler::ui
