#include "game/ui/cards/goal_counts.hpp"
#include "game/ui/cards/level_text.hpp"
#include "game/ui/cards/play_cards.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"
#include "render/panels/unbroken.hpp"

#include <algorithm>
#include <utility>

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

std::vector<GoalLine> linesOf(Session const& session, LevelText const* said, std::span<int const> counts,
                              std::span<GoalStatus const> goals) {
    std::vector<GoalLine> lines;
    for (GoalStatus const& goal : goals.empty() ? std::span(session.judge().status()) : goals) {
        bool const known = said != nullptr && lines.size() < said->goals().size();
        std::string const& text = known ? said->goals()[lines.size()] : goal.text;
        bool const underWay = !goal.met && goal.progress > 0 && goal.progress < 1;
        std::string words = words::capital(text);
        int const count = lines.size() < counts.size() ? counts[lines.size()] : 0;
        if (count > 1 && session.mode() != SessionMode::building) {
            words += " (" + textWith("goal.counted", reachedOf(goal, count), count) + ")";
        }
        lines.push_back({std::move(words), goal.met ? GoalLine::State::Met : GoalLine::State::Open,
                         underWay ? static_cast<float>(goal.progress) : -1.F});
    }
    return lines;
}

void drawHints(std::vector<std::string> const& hints, std::size_t hintsShown, CommandButtons& buttons) {
    std::size_t const shown = std::min(hintsShown, hints.size());
    for (std::size_t i = 0; i < shown; ++i) {
        smallHeading(words::hintOf(i + 1, hints.size()));
        // A heading stands closer to the text below it.
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() - scaled(5));
        ImGui::TextWrapped("%s", unbroken(hints[i]).c_str());
        ImGui::Dummy({0, scaled(2)});
    }
    if (shown < hints.size()) {
        buttons.big("hint", {.label = shown == 0 ? words::hint : words::nextHint});
    }
    // A new hint is seen at once, also on a card that scrolls.
    int& seen = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("hints seen"), 0);
    if (std::exchange(seen, static_cast<int>(shown)) != static_cast<int>(shown)) {
        ImGui::SetScrollHereY(1.F);
    }
}

/// Each line with its button at the right end; returns the one that was pressed.
std::optional<std::size_t> drawAskedLines(Layout& layout, std::vector<GoalLine> const& lines,
                                          CommandButtons const& buttons) {
    std::optional<std::size_t> asked;
    std::string const tip = buttons.tip("why-goal");
    ImGui::PushFont(theme().fonts.small);
    float const word = std::max(ImGui::CalcTextSize(text("Why?")).x, ImGui::CalcTextSize(text("Why not?")).x);
    ImGui::PopFont();
    float const width = word + scaled(14);
    if (!ImGui::BeginTable("goals", 2, ImGuiTableFlags_NoPadOuterX)) {
        return asked;
    }
    ImGui::TableSetupColumn("goal", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("why", ImGuiTableColumnFlags_WidthFixed, width);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        goalLines({&lines[i], 1});
        ImGui::TableNextColumn();
        ImGui::PushFont(theme().fonts.small);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, scaled(2)));
        bool const met = lines[i].state == GoalLine::State::Met;
        std::string const label =
            std::string(met ? text("Why?") : text("Why not?")) + "##" + std::to_string(i);
        if (ImGui::Button(label.c_str(), {width, 0})) {
            asked = i;
        }
        layout.item("why goal " + std::to_string(i + 1));
        ImGui::PopStyleVar();
        ImGui::PopFont();
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", tip.c_str());
        }
    }
    ImGui::EndTable();
    return asked;
}

} // namespace

std::optional<std::string> drawGoalCard(Layout& layout, Session const& session, GoalCardLook const& look,
                                        CommandButtons* buttons) {
    LevelFile const& level = session.level();
    std::string const& title = look.said != nullptr ? look.said->title() : level.title;
    std::string const& story = look.said != nullptr ? look.said->text() : level.text;
    std::vector<std::string> const& hints = look.said != nullptr ? look.said->hints() : level.hints;
    std::optional<std::string> asked;
    layout.beginCard("goal", "", {.anchor = Anchor::TopLeft, .width = goalCardWidth});
    ImGui::PushFont(theme().fonts.heading);
    ImGui::TextWrapped("%s", title.c_str());
    ImGui::PopFont();
    ImVec2 const low = ImGui::GetItemRectMin();
    float const y = ImGui::GetItemRectMax().y + scaled(2);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, y}, {low.x + scaled(36), y + scaled(3)},
                                              imColour(palette::accent), scaled(1.5F));
    ImGui::Dummy({0, scaled(3)});
    // Text that does not fit between the heading and the buttons scrolls; the height used is that of the last
    // picture.
    ImGuiID const heightId = ImGui::GetID("height of the content");
    float const height = ImGui::GetStateStorage()->GetFloat(heightId);
    float const most = ImGui::GetIO().DisplaySize.y - scaled(2 * cardGap + bottomRow + look.below) -
                       ImGui::GetStyle().WindowPadding.y - ImGui::GetCursorPosY();
    bool const scrolls = height > most;
    if (scrolls) {
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::BeginChild("content", {0, most});
    }
    float const top = ImGui::GetCursorPosY();
    if (!look.brief && !story.empty()) {
        caption(story.c_str());
        rule();
    }
    std::vector<GoalLine> const lines = linesOf(session, look.said, look.counts, look.goals);
    if (lines.empty()) {
        caption(words::noGoal);
    } else {
        if (!look.brief) {
            smallHeading(look.task ? text("goal.task") : lines.size() > 1 ? words::goals : words::goal);
        }
        if (look.why && buttons != nullptr) {
            auto const line = drawAskedLines(layout, lines, *buttons);
            if (line && *line < session.judge().status().size()) {
                asked = session.judge().status()[*line].id;
            }
        } else {
            goalLines(lines);
        }
    }
    if (!look.brief && buttons != nullptr && !hints.empty()) {
        rule();
        drawHints(hints, look.hintsShown, *buttons);
    }
    float const drawn = ImGui::GetCursorPosY() - top;
    if (scrolls) {
        ImGui::EndChild();
        ImGui::PopStyleColor();
    }
    ImGui::GetStateStorage()->SetFloat(heightId, drawn);
    layout.endCard();
    return asked;
}

} // namespace trembler::ui
