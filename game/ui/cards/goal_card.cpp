#include "game/ui/cards/goal_counts.hpp"
#include "game/ui/cards/play_cards.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

namespace trembler::ui {
namespace {

using namespace render;

void rule() {
    ImGui::Dummy({0, scaled(1)});
    ImVec2 const at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine(at, {at.x + ImGui::GetContentRegionAvail().x, at.y},
                                        imColour(palette::paperShade), scaled(1.4F));
    ImGui::Dummy({0, scaled(3)});
}

void smallHeading(std::string const& text) {
    ImGui::PushFont(theme().fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::accent));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

std::vector<GoalLine> linesOf(Session const& session, std::span<int const> counts) {
    std::vector<GoalLine> lines;
    for (GoalStatus const& goal : session.judge().status()) {
        bool const underWay = !goal.met && goal.progress > 0 && goal.progress < 1;
        std::string words = words::capital(goal.text);
        int const count = lines.size() < counts.size() ? counts[lines.size()] : 0;
        if (count > 1 && session.mode() != SessionMode::building) {
            words += " (" + textWith("goal.counted", reachedOf(goal, count), count) + ")";
        }
        lines.push_back({std::move(words), goal.met ? GoalLine::State::Met : GoalLine::State::Open,
                         underWay ? static_cast<float>(goal.progress) : -1.F});
    }
    return lines;
}

void drawHints(Session const& session, std::size_t hintsShown, CommandButtons& buttons) {
    auto const& hints = session.level().hints;
    std::size_t const shown = std::min(hintsShown, hints.size());
    for (std::size_t i = 0; i < shown; ++i) {
        smallHeading(words::hintOf(i + 1, hints.size()));
        // A heading stands closer to the text below it.
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() - scaled(5));
        ImGui::TextWrapped("%s", hints[i].c_str());
        ImGui::Dummy({0, scaled(2)});
    }
    if (shown < hints.size()) {
        buttons.big("hint", {.label = shown == 0 ? words::hint : words::nextHint});
    }
}

} // namespace

void drawGoalCard(Layout& layout, Session const& session, GoalCardLook const& look, CommandButtons* buttons) {
    LevelFile const& level = session.level();
    layout.beginCard("goal", "", {.anchor = Anchor::TopLeft, .width = goalCardWidth});
    ImGui::PushFont(theme().fonts.heading);
    ImGui::TextWrapped("%s", level.title.c_str());
    ImGui::PopFont();
    ImVec2 const low = ImGui::GetItemRectMin();
    float const y = ImGui::GetItemRectMax().y + scaled(2);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, y}, {low.x + scaled(36), y + scaled(3)},
                                              imColour(palette::accent), scaled(1.5F));
    ImGui::Dummy({0, scaled(3)});
    if (!look.brief && !level.text.empty()) {
        caption(level.text.c_str());
        rule();
    }
    std::vector<GoalLine> const lines = linesOf(session, look.counts);
    if (lines.empty()) {
        caption(words::noGoal);
    } else {
        if (!look.brief) {
            smallHeading(look.task ? text("goal.task") : words::goal);
        }
        goalLines(lines);
    }
    if (!look.brief && buttons != nullptr && !level.hints.empty()) {
        rule();
        drawHints(session, look.hintsShown, *buttons);
    }
    layout.endCard();
}

} // namespace trembler::ui
