#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/panels/field_widgets.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "puzzle/edit/commands/solutions.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"
#include "runtime/level/json/limits.hpp"

#include <deque>
#include <map>
#include <optional>
#include <string_view>

namespace trembler::ui {
namespace {

using namespace render;
using edit::Json;

/// Where a solution lies in the file: entries that cannot be read are not among those shown. Where it was
/// when the file was read, if one of its name is there still, else by its name.
std::optional<std::size_t> indexInFile(Json const& level, Solution const& solution) {
    auto const list = level.find("solutions");
    std::optional<std::size_t> found;
    for (std::size_t i = 0; list != level.end() && list->is_array() && i < list->size(); ++i) {
        Json const& entry = (*list)[i];
        if (!entry.is_object() || entry.value("name", Json("")) != solution.name) {
            continue;
        }
        if (!found || solution.path == "/solutions/" + std::to_string(i)) {
            found = i;
        }
    }
    return found;
}

/// The solutions as they were read, in the order that the file has now: a level that takes long to read is
/// read some time after a change. Equal names keep the order in which they were read.
std::vector<Solution> inOrderOfFile(EditParts const& parts) {
    std::vector<Solution> const& read = parts.level.solutions;
    std::map<std::string_view, std::deque<std::size_t>> left;
    for (std::size_t i = 0; i < read.size(); ++i) {
        left[read[i].name].push_back(i);
    }
    std::vector<Solution> ordered;
    auto const list = parts.tree().find("solutions");
    if (list != parts.tree().end() && list->is_array()) {
        for (Json const& entry : *list) {
            auto const name = entry.is_object() ? entry.find("name") : entry.end();
            if (name == entry.end() || !name->is_string()) {
                continue;
            }
            if (auto const found = left.find(name->get_ref<std::string const&>());
                found != left.end() && !found->second.empty()) {
                ordered.push_back(read[found->second.front()]);
                found->second.pop_front();
            }
        }
    }
    if (ordered.size() != read.size()) { // one was renamed or removed since
        return read;
    }
    return ordered;
}

/// Moves a solution to where another one is; nothing if the file has changed since it was read.
void moveSolutionTo(EditParts& parts, Solution const& solution, Solution const& other) {
    auto const from = indexInFile(parts.tree(), solution);
    auto const to = indexInFile(parts.tree(), other);
    if (from && to) {
        parts.run([&](Json const& level) { return edit::moveSolution(level, *from, *to); });
    }
}

void drawSolution(EditParts& parts, std::vector<Solution> const& all, std::size_t index) {
    Solution const& solution = all[index];
    std::size_t const count = all.size();
    std::string const item = "solution " + std::to_string(index);
    std::string name = solution.name;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - (count > 1 ? orderArrowsWidth() : 0));
    if (committedText(parts, item, name)) {
        parts.run([&](Json const& level) { return edit::renameSolution(level, solution.name, name); });
    }
    if (count > 1) {
        if (auto const to = orderArrows(parts, item, index, count)) {
            moveSolutionTo(parts, solution, all[*to]);
        }
    }
    bool solves = solution.solves;
    if (render::checkBox((std::string(words::solvesLevel) + "##" + item).c_str(), &solves)) {
        parts.run([&](Json const& level) { return edit::expectSolved(level, solution.name, solves); });
    }
    parts.context.layout.item(item + " solves");
    double frames = solution.frames.value_or(0);
    fieldName(words::framesField, words::framesTip);
    if (numberField(parts, item + " frames", frames, 0, static_cast<double>(limits::frames), "", true)) {
        runWidget(
            parts,
            [&](Json const& level) {
                return edit::setSolutionFrames(level, solution.name, static_cast<int>(frames));
            },
            true);
    }
    if (smallButton(parts, words::watch, item + " watch", words::watchTip)) {
        actions::playSolution(parts, solution.name, false);
    }
    besideIfRoom(words::again);
    if (smallButton(parts, words::again, item + " again", words::againTip)) {
        actions::playSolution(parts, solution.name, true);
    }
    besideIfRoom(words::removeIt);
    if (smallButton(parts, words::removeIt, item + " remove")) {
        parts.run([&](Json const& level) { return edit::removeSolution(level, solution.name); });
    }
    ImGui::Separator();
}

} // namespace

void drawSolutionsPage(EditParts& parts) {
    if (parts.level.solutions.empty()) {
        caption(words::noSolutions);
    }
    std::vector<Solution> const solutions = inOrderOfFile(parts);
    for (std::size_t i = 0; i < solutions.size(); ++i) {
        // By its name, so that the ring of the keyboard stays with a solution that is moved.
        ImGui::PushID(solutions[i].name.c_str());
        drawSolution(parts, solutions, i);
        ImGui::PopID();
    }
    if (smallButton(parts, words::recordNew, "record new", words::recordNewTip)) {
        actions::testPlay(parts);
    }
}

} // namespace trembler::ui
