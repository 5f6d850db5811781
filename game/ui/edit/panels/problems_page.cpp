#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/theme.hpp"

namespace trembler::ui {
namespace {

using namespace render;
using About = edit::Problem::About;

/// Shows and selects the entry at which the problem is.
void showCulprit(EditParts& parts, edit::Problem const& problem) {
    std::string const index = std::to_string(problem.index.value_or(0));
    switch (problem.about) {
    case About::object:
        parts.selection.set({problem.name});
        parts.selection.choosePiece(problem.piece);
        parts.tab = Tab::properties;
        break;
    case About::joint:
        parts.selection.choose(EntryKind::joint, "/joints/" + index);
        parts.tab = Tab::properties;
        break;
    case About::connection:
        parts.selection.choose(EntryKind::connection, "/connections/" + index);
        parts.tab = Tab::properties;
        break;
    case About::placing:
        parts.selection.choose(EntryKind::placing, "/placing/" + index);
        break;
    case About::goal:
    case About::task:
        parts.goalTree = problem.about == About::task ? edit::GoalTree::task : edit::GoalTree::goals;
        parts.goalPlace = problem.name;
        parts.goalChosen = true;
        parts.tab = Tab::goals;
        break;
    case About::solution:
        parts.tab = Tab::solutions;
        break;
    case About::ownPart: // the file has to be corrected elsewhere
        parts.tell(shownFault(problem.diagnostic), ToastKind::Trouble);
        break;
    case About::level:
    case About::world:
    case About::tool:
    case About::hint:
        parts.tab = Tab::level;
        break;
    }
}

} // namespace

void drawProblemsPage(EditParts& parts) {
    std::vector<edit::Problem> const problems = parts.problems.all();
    if (problems.empty()) {
        caption(words::noProblems);
        return;
    }
    for (std::size_t i = 0; i < problems.size(); ++i) {
        edit::Problem const& problem = problems[i];
        std::string const text =
            (problem.name.empty() ? std::string() : problem.name + ": ") + shownMessage(problem.diagnostic);
        float const width = ImGui::GetContentRegionAvail().x;
        ImVec2 const size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width - scaled(22));
        ImGui::PushID(static_cast<int>(i));
        ImVec2 const at = ImGui::GetCursorScreenPos();
        if (ImGui::Selectable("##problem", false, 0, {width, size.y + scaled(6)})) {
            showCulprit(parts, problem);
        }
        parts.context.layout.item("problem " + std::to_string(i));
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddCircleFilled({at.x + scaled(7), at.y + scaled(12)}, scaled(5), imColour(palette::warning));
        list.AddText(nullptr, 0, {at.x + scaled(20), at.y + scaled(2)}, imColour(palette::ink), text.c_str(),
                     nullptr, width - scaled(22));
        ImGui::PopID();
    }
}

} // namespace trembler::ui
