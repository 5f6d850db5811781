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

/// What the card says.
struct Told {
    std::string title;
    std::string story; ///< "" while it is not shown
    std::string heading;
    std::vector<GoalLine> lines;
};

Told toldBy(Session const& session, GoalCardLook const& look) {
    LevelFile const& level = session.level();
    Told told;
    told.title = look.said != nullptr ? look.said->title() : level.title;
    if (!look.brief) {
        told.story = look.said != nullptr ? look.said->text() : level.text;
    }
    told.lines = linesOf(session, look.said, look.counts, look.goals);
    told.heading = look.task ? text("goal.task") : told.lines.size() > 1 ? words::goals : words::goal;
    return told;
}

/// Calls `draw`, for content that scrolls if it is higher than `most` pixels; the height that counts is that
/// of the last picture.
template <class Draw>
void scrolledBeyond(char const* id, float most, Draw&& draw) {
    ImGuiID const heightId = ImGui::GetID(id);
    bool const scrolls = ImGui::GetStateStorage()->GetFloat(heightId) > most;
    if (scrolls) {
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::BeginChild(id, {0, most});
    }
    float const top = ImGui::GetCursorPosY();
    draw();
    float const drawn = ImGui::GetCursorPosY() - top;
    if (scrolls) {
        ImGui::EndChild();
        ImGui::PopStyleColor();
    }
    ImGui::GetStateStorage()->SetFloat(heightId, drawn);
}

/// As far down as the card may reach.
float roomBelow(float most) {
    return std::max(most - ImGui::GetStyle().WindowPadding.y - ImGui::GetCursorPosY(),
                    2 * ImGui::GetTextLineHeight());
}

void drawTitle(std::string const& title, float width) {
    ImGui::PushFont(theme().fonts.heading);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    ImGui::TextUnformatted(title.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImVec2 const low = ImGui::GetItemRectMin();
    float const y = ImGui::GetItemRectMax().y + scaled(2);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, y}, {low.x + scaled(36), y + scaled(3)},
                                              imColour(palette::accent), scaled(1.5F));
    ImGui::Dummy({0, scaled(3)});
}

/// Draws all parts of the card; asked() has what the player wants.
class GoalCard {
public:
    GoalCard(Layout& layout, Session const& session, GoalCardLook const& look, CommandButtons* buttons)
        : layout_(layout), session_(session), look_(look), buttons_(buttons), told_(toldBy(session, look)) {}

    [[nodiscard]] GoalCardAsked const& asked() const { return asked_; }

    /// One below the other, as high as the window allows.
    void drawColumn() {
        drawTitle(told_.title, ImGui::GetContentRegionAvail().x);
        float const most = ImGui::GetIO().DisplaySize.y - scaled(2 * cardGap + bottomRow);
        scrolledBeyond("content", roomBelow(most), [&] {
            if (!told_.story.empty()) {
                caption(told_.story.c_str());
                rule();
            }
            drawGoals();
        });
    }

    /// The story at the left, the goals at the right of it; without goals the story is there, and the card
    /// low.
    void drawWide() {
        float const most = scaled(look_.most);
        bool const hint = look_.hint != nullptr && buttons_ != nullptr;
        if (!ImGui::BeginTable("columns", hint ? 3 : 2, ImGuiTableFlags_NoPadOuterX)) {
            return;
        }
        ImGui::TableSetupColumn("story", ImGuiTableColumnFlags_WidthStretch, 0.52F);
        ImGui::TableSetupColumn("goals", ImGuiTableColumnFlags_WidthStretch, 0.48F);
        if (hint) {
            ImGui::TableSetupColumn("hint", ImGuiTableColumnFlags_WidthFixed, hintWidth());
        }
        ImGui::TableNextColumn();
        drawTitle(told_.title, ImGui::GetContentRegionAvail().x);
        bool const onlyStory = told_.lines.empty() && !told_.story.empty();
        auto const drawStory = [&] {
            scrolledBeyond("story", roomBelow(most), [&] { smallCaption(told_.story.c_str()); });
        };
        if (onlyStory) {
            smallCaption(words::noGoal);
        } else if (!told_.story.empty()) {
            drawStory();
        }
        ImGui::TableNextColumn();
        if (onlyStory) {
            drawStory();
        } else {
            scrolledBeyond("goals", roomBelow(most), [&] { drawGoals(); });
        }
        if (hint) {
            ImGui::TableNextColumn();
            buttons_->big("hint", {.label = look_.hint, .width = -1});
        }
        ImGui::EndTable();
    }

    /// In a narrow window: the goals, and the story as long as the player wants to read it.
    void drawNarrow() {
        bool const open = look_.storyOpen.value_or(false);
        drawNarrowHead(open);
        scrolledBeyond("content", roomBelow(scaled(look_.most)), [&] {
            if (!told_.story.empty() && open) {
                smallCaption(told_.story.c_str());
                rule();
            }
            drawGoals();
        });
    }

private:
    void drawGoals() {
        if (told_.lines.empty()) {
            caption(words::noGoal);
            return;
        }
        if (!look_.brief && (look_.width <= 0 || isWideStrip(look_.width))) {
            smallHeading(told_.heading);
        }
        if (look_.why && buttons_ != nullptr) {
            auto const line = drawAskedLines(layout_, told_.lines, *buttons_);
            if (line && *line < session_.judge().status().size()) {
                asked_.why = session_.judge().status()[*line].id;
            }
        } else {
            goalLines(told_.lines);
        }
    }

    void drawNarrowHead(bool open) {
        bool const hint = look_.hint != nullptr && buttons_ != nullptr;
        bool const fold = !told_.story.empty() && buttons_ != nullptr;
        char const* const foldLabel = open ? words::lessStory : words::moreStory;
        float const gap = scaled(8);
        float const foldWidth =
            std::max(ImGui::CalcTextSize(words::lessStory).x, ImGui::CalcTextSize(words::moreStory).x) +
            scaled(18);
        float const taken = (hint ? scaled(40) + gap : 0) + (fold ? foldWidth + gap : 0);
        ImVec2 const start = ImGui::GetCursorPos();
        float const room = ImGui::GetContentRegionAvail().x - taken;
        drawTitle(told_.title, room);
        float bottom = ImGui::GetCursorPosY();
        if (fold || hint) {
            ImGui::SetCursorPos({start.x + room + gap, start.y});
        }
        if (fold) {
            if (ImGui::Button(foldLabel, {foldWidth, scaled(34)})) {
                asked_.storyOpen = !open;
            }
            layout_.item("story");
            bottom = std::max(bottom, ImGui::GetCursorPosY());
        }
        if (hint) {
            if (fold) {
                ImGui::SameLine(0, gap);
            }
            buttons_->icon("hint");
            bottom = std::max(bottom, ImGui::GetCursorPosY());
        }
        ImGui::SetCursorPos({start.x, bottom});
    }

    /// Of the longest words that the button can have, pixels.
    [[nodiscard]] static float hintWidth() {
        ImGui::PushFont(theme().fonts.strong);
        float widest = 0;
        for (char const* const label :
             {static_cast<char const*>(words::hint), words::nextHint, words::foldHints}) {
            widest = std::max(widest, ImGui::CalcTextSize(label).x);
        }
        float const icon = ImGui::GetFontSize();
        ImGui::PopFont();
        return widest + icon + scaled(9 + 36);
    }

    Layout& layout_;
    Session const& session_;
    GoalCardLook const& look_;
    CommandButtons* const buttons_;
    Told const told_;
    GoalCardAsked asked_;
};

} // namespace

bool isWideStrip(float width) {
    constexpr float least = 600;
    return width >= least;
}

GoalCardAsked drawGoalCard(Layout& layout, Session const& session, GoalCardLook const& look,
                           CommandButtons* buttons) {
    layout.beginCard("goal", "",
                     {.anchor = Anchor::TopLeft, .width = look.width > 0 ? look.width : goalCardWidth});
    GoalCard card(layout, session, look, buttons);
    if (look.width <= 0) {
        card.drawColumn();
    } else if (isWideStrip(look.width)) {
        card.drawWide();
    } else {
        card.drawNarrow();
    }
    layout.endCard();
    return card.asked();
}

} // namespace trembler::ui
