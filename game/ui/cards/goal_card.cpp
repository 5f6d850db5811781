#include "game/ui/cards/play_cards.hpp"
#include "game/ui/play/view/level_text.hpp"
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

std::vector<GoalLine> linesOf(Session const& session, LevelText const* said) {
    std::vector<GoalLine> lines;
    for (GoalStatus const& goal : session.judge().status()) {
        bool const known = said != nullptr && lines.size() < said->goals().size();
        std::string const& text = known ? said->goals()[lines.size()] : goal.text;
        bool const underWay = !goal.met && goal.progress > 0 && goal.progress < 1;
        lines.push_back({words::capital(text), goal.met ? GoalLine::State::Met : GoalLine::State::Open,
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
    std::string const& title = look.said != nullptr ? look.said->title() : level.title;
    std::string const& text = look.said != nullptr ? look.said->text() : level.text;
    std::vector<std::string> const& hints = look.said != nullptr ? look.said->hints() : level.hints;
    layout.beginCard("goal", "", {.anchor = Anchor::TopLeft, .width = goalCardWidth});
    ImGui::PushFont(theme().fonts.heading);
    ImGui::TextWrapped("%s", title.c_str());
    ImGui::PopFont();
    ImVec2 const low = ImGui::GetItemRectMin();
    float const y = ImGui::GetItemRectMax().y + scaled(2);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, y}, {low.x + scaled(36), y + scaled(3)},
                                              imColour(palette::accent), scaled(1.5F));
    ImGui::Dummy({0, scaled(3)});
    if (!look.brief && !text.empty()) {
        caption(text.c_str());
        rule();
    }
    std::vector<GoalLine> const lines = linesOf(session, look.said);
    if (lines.empty()) {
        caption(words::noGoal);
    } else {
        if (!look.brief) {
            smallHeading(words::goal);
        }
        goalLines(lines);
    }
    if (!look.brief && buttons != nullptr && !hints.empty()) {
        rule();
        drawHints(hints, look.hintsShown, *buttons);
    }
    layout.endCard();
}

} // namespace trembler::ui
