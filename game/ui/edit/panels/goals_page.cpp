#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/goals/goal_fields.hpp"
#include "game/ui/edit/goals/goal_words.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "game/ui/edit/view/edit_geometry.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/goals/reading/condition_outline.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/icons.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>

namespace trembler::ui {
namespace {

using namespace render;
using edit::Json;

/// "touching: iron ball, electromagnet".
std::string summaryOf(edit::GoalLine const& line) {
    std::string text = line.kind.empty() ? "?" : shownGoalWord(line.kind);
    if (!line.condition.is_object() || !line.condition.contains(line.kind)) {
        return text;
    }
    std::string about;
    auto const add = [&](Json const& value) {
        if (value.is_string()) {
            about += (about.empty() ? "" : ", ") + value.get<std::string>();
        } else if (value.is_object() && value.contains("part") && value["part"].is_string()) {
            about += (about.empty() ? "" : ", ") + value["part"].get<std::string>();
        }
    };
    Json const& body = line.condition[line.kind];
    add(body);
    if (body.is_array() || body.is_object()) {
        for (Json const& one : body) {
            add(one);
        }
    }
    text += about.empty() ? "" : ": " + about;
    if (line.condition.contains("for") && line.condition["for"].is_number()) {
        std::array<char, 32> seconds{};
        std::snprintf(seconds.data(), seconds.size(), ", %.3g s", line.condition["for"].get<double>());
        text += seconds.data();
    }
    return text;
}

/// A tick or a cross at the end of the last line, as the condition stands in the test play.
void drawGoalState(EditParts const& parts, std::string const& place) {
    auto const state = parts.goals.states().find(place);
    if (parts.goalTree != parts.playedTree || state == parts.goals.states().end()) {
        return;
    }
    ImVec2 const at{ImGui::GetItemRectMax().x - scaled(10),
                    0.5F * (ImGui::GetItemRectMin().y + ImGui::GetItemRectMax().y)};
    bool const met = state->second.met || state->second.once;
    drawIcon(*ImGui::GetWindowDrawList(), met ? Icon::Tick : Icon::Cross, at, scaled(12),
             imColour(state->second.met ? palette::goal
                      : met             ? palette::accent
                                        : palette::warning));
}

Json const* conditionAt(EditParts const& parts, std::string const& place) {
    try {
        std::string const root = std::string("/") + edit::keyOf(parts.goalTree);
        return &parts.tree().at(Json::json_pointer(root + place));
    } catch (nlohmann::json::exception const&) {
        return nullptr;
    }
}

/// How many conditions are in the list around a condition; 0: it is in none.
std::size_t listAround(EditParts const& parts, std::string const& place) {
    std::size_t const end = place.rfind('/');
    if (place.empty() || end == std::string::npos) {
        return 0;
    }
    Json::json_pointer const list(std::string("/") + edit::keyOf(parts.goalTree) + place.substr(0, end));
    bool const there = parts.tree().contains(list) && parts.tree().at(list).is_array();
    return there ? parts.tree().at(list).size() : 0;
}

/// The kinds into which any condition can be put: first lists, then those of a single condition.
std::vector<std::string> kindsAround() {
    std::vector<std::string> kinds;
    for (InnerConditions const inner : {InnerConditions::list, InnerConditions::value}) {
        for (ConditionOutline const& outline : conditionOutlines()) {
            if (outline.inner == inner) {
                kinds.push_back(outline.key);
            }
        }
    }
    return kinds;
}

void drawChosen(EditParts& parts, edit::GoalLine const& line) {
    Json const* const found = conditionAt(parts, line.place);
    if (found == nullptr) {
        return;
    }
    Json condition = *found;
    pageHeading(shownGoalWord(line.kind).c_str());
    ConditionOutline const* const outline = findOutline(line.kind);
    bool const hasFields = outline == nullptr || (outline->inner != InnerConditions::list &&
                                                  outline->inner != InnerConditions::value);
    if (!line.takesMore && hasFields && condition.contains(line.kind)) {
        if (goalFields(parts, line.kind, condition[line.kind])) {
            runWidget(
                parts,
                [&](Json const& level) {
                    return edit::changeGoal(level, line.place, condition, parts.goalTree);
                },
                true);
        }
    }
    double seconds =
        condition.contains("for") && condition["for"].is_number() ? condition["for"].get<double>() : 0;
    fieldName(words::forSeconds, words::forSecondsTip);
    if (numberField(parts, "goal for", seconds, 0, 3600, "s")) {
        runWidget(
            parts,
            [&](Json const& level) {
                return edit::setGoalOption(level, line.place, "for", seconds > 0 ? Json(seconds) : Json(),
                                           parts.goalTree);
            },
            true);
    }
    for (auto const& [key, title] : {std::pair{"id", words::goalId}, std::pair{"text", words::goalText}}) {
        std::string text =
            condition.contains(key) && condition[key].is_string() ? condition[key].get<std::string>() : "";
        fieldName(title, words::goalTextTip);
        if (committedText(parts, std::string("goal ") + key, text)) {
            runWidget(
                parts,
                [&, option = std::string(key)](Json const& level) {
                    return edit::setGoalOption(level, line.place, option, text.empty() ? Json() : Json(text),
                                               parts.goalTree);
                },
                false);
        }
    }
    std::vector<std::string> const around = kindsAround();
    for (std::string const& kind : around) {
        std::string const label = shownGoalWord(kind);
        if (kind != around.front()) {
            besideIfRoom(label.c_str());
        }
        if (smallButton(parts, label.c_str(), "wrap " + kind, words::wrapTip)) {
            parts.run(
                [&](Json const& level) { return edit::wrapGoal(level, line.place, kind, parts.goalTree); });
        }
    }
    if (smallButton(parts, words::unwrap, "unwrap", words::unwrapTip)) {
        parts.run([&](Json const& level) { return edit::unwrapGoal(level, line.place, parts.goalTree); });
    }
    besideIfRoom(words::removeIt);
    bool removed = false;
    if (smallButton(parts, words::removeIt, "remove goal")) {
        if (parts.run(
                [&](Json const& level) { return edit::removeGoal(level, line.place, parts.goalTree); })) {
            parts.goalChosen = false;
            removed = true;
        }
    }
    std::size_t const inList = removed ? 0 : listAround(parts, line.place);
    if (inList > 1) {
        if (auto const to = orderArrows(parts, "goal", indexOfPath(line.place), inList)) {
            bool const moved = parts.run(
                [&](Json const& level) { return edit::moveGoal(level, line.place, *to, parts.goalTree); });
            if (moved) { // it is still the chosen one
                parts.goalPlace = line.place.substr(0, line.place.rfind('/') + 1) + std::to_string(*to);
                if (parts.selection.kind() == EntryKind::goalArea) {
                    parts.selection.choose(EntryKind::goalArea, parts.goalPlace);
                }
            }
        }
    }
}

void drawAdd(EditParts& parts, std::vector<edit::GoalLine> const& lines) {
    std::string chosen;
    std::vector<std::string> kinds;
    for (ConditionOutline const& outline : conditionOutlines()) {
        kinds.push_back(outline.key);
    }
    ImGui::TextUnformatted(words::addGoal);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (!choiceField(parts, "add goal", chosen, kinds, shownGoalWord)) {
        return;
    }
    std::string place;
    for (edit::GoalLine const& line : lines) {
        if (parts.goalChosen && line.place == parts.goalPlace && line.takesMore) {
            place = line.place;
        }
    }
    Vec2 const middle = parts.middleOfView();
    Area const area{Box{middle - Vec2{0.5, 0.5}, {1, 1}}, {}};
    parts.run([&](Json const& level) {
        std::vector<std::string> objects = parts.selected();
        for (std::string const& name : edit::objectNames(level)) { // something to begin with
            if (objects.size() < 2 && std::find(objects.begin(), objects.end(), name) == objects.end()) {
                objects.push_back(name);
            }
        }
        return edit::addGoal(level, place, edit::newCondition(chosen, objects, area), parts.goalTree);
    });
}

/// Only a demonstration has two trees; a task that it lost with the mark can still be removed.
void drawTreeChoice(EditParts& parts) {
    bool const two = parts.level.demonstration || parts.tree().contains("task");
    if (!two) {
        parts.goalTree = edit::GoalTree::goals;
        return;
    }
    for (auto const& [tree, label] : {std::pair{edit::GoalTree::goals, words::ownGoals},
                                      std::pair{edit::GoalTree::task, words::taskGoals}}) {
        if (tree == edit::GoalTree::task) {
            besideIfRoom(label);
        }
        bool const on = parts.goalTree == tree;
        if (on) {
            ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        }
        bool const chosen = smallButton(parts, label, std::string("tree ") + edit::keyOf(tree),
                                        tree == edit::GoalTree::task ? words::taskTip : words::ownGoalsTip);
        if (on) {
            ImGui::PopStyleColor();
        }
        if (chosen && !on) {
            parts.goalTree = tree;
            parts.goalChosen = false;
            if (parts.selection.kind() == EntryKind::goalArea) { // of the other tree
                parts.selection.clear();
            }
        }
    }
}

} // namespace

void drawLiveGoals(EditParts& parts, float top) {
    auto const lines = edit::goalLines(parts.tree(), parts.playedTree);
    if (lines.empty() || parts.goals.states().empty()) {
        return;
    }
    parts.context.layout.beginCard("live goals", words::tabGoals,
                                   {.anchor = Anchor::TopRight, .offset = {16, top}, .width = 270});
    for (edit::GoalLine const& line : lines) {
        ImGui::Indent(scaled(14) * static_cast<float>(line.depth) + 0.01F);
        float const room = ImGui::GetContentRegionAvail().x;
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room - scaled(22));
        ImGui::TextUnformatted(summaryOf(line).c_str());
        ImGui::PopTextWrapPos();
        // The state stands at the end of the line, not of the words.
        ImVec2 const low = ImGui::GetItemRectMin();
        ImVec2 const high = ImGui::GetItemRectMax();
        auto const state = parts.goals.states().find(line.place);
        if (state != parts.goals.states().end()) {
            bool const met = state->second.met;
            drawIcon(*ImGui::GetWindowDrawList(), met ? Icon::Tick : Icon::Cross,
                     {low.x + room - scaled(10), 0.5F * (low.y + high.y)}, scaled(13),
                     imColour(met ? palette::goal : palette::warning));
        }
        ImGui::Unindent(scaled(14) * static_cast<float>(line.depth) + 0.01F);
    }
    parts.context.layout.endCard();
}

void drawGoalsPage(EditParts& parts) {
    drawTreeChoice(parts);
    auto const lines = edit::goalLines(parts.tree(), parts.goalTree);
    if (lines.empty()) {
        caption(parts.goalTree == edit::GoalTree::task ? words::noTask : words::noGoals);
    }
    edit::GoalLine const* chosen = nullptr;
    for (edit::GoalLine const& line : lines) {
        ImGui::Indent(scaled(14) * static_cast<float>(line.depth) + 0.01F);
        std::string const label = summaryOf(line) + "##" + line.place;
        bool const on = parts.goalChosen && parts.goalPlace == line.place;
        if (ImGui::Selectable(label.c_str(), on)) {
            parts.goalPlace = line.place;
            parts.goalChosen = true;
            if (line.condition.is_object() && line.kind == "inside") {
                parts.selection.choose(EntryKind::goalArea, line.place);
            }
        }
        parts.context.layout.item("goal " + line.place);
        drawGoalState(parts, line.place);
        ImGui::Unindent(scaled(14) * static_cast<float>(line.depth) + 0.01F);
        if (on) {
            chosen = &line;
        }
    }
    drawAdd(parts, lines);
    if (chosen != nullptr) {
        drawChosen(parts, *chosen);
    }
}

} // namespace trembler::ui
