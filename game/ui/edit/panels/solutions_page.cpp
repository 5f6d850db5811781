#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "game/ui/edit/panels/solution_entries.hpp"
#include "puzzle/edit/commands/solutions.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"
#include "runtime/level/json/limits.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace trembler::ui {
namespace {

using namespace render;
using edit::Json;

/// A solution as it was read, and its place in the list that the file has now; nothing if it has been renamed
/// or removed since.
struct ShownSolution {
    Solution solution;
    std::optional<std::size_t> index;
};

/// The name of an entry of the list; nothing if it has none.
std::optional<std::string_view> nameOf(Json const& entry) {
    auto const name = entry.is_object() ? entry.find("name") : entry.end();
    if (!entry.is_object() || name == entry.end() || !name->is_string()) {
        return std::nullopt;
    }
    return name->get_ref<std::string const&>();
}

/// The solutions in the order that the file has now: a level that takes long to read is read some time after
/// a change. Entries that cannot be read are not among them. A solution is where it was read if one of its
/// name is still there; of the others equal names keep the order in which they were read. So do all if one
/// has been renamed or removed since.
std::vector<ShownSolution> shownSolutions(EditParts const& parts) {
    std::vector<ShownSolution> shown;
    std::map<std::string, std::size_t> read; // by path
    for (Solution const& solution : parts.level.solutions) {
        read[solution.path] = shown.size();
        shown.push_back({solution, std::nullopt});
    }
    auto const found = parts.tree().find("solutions");
    std::size_t const count = found != parts.tree().end() && found->is_array() ? found->size() : 0;
    std::vector<bool> taken(count, false);
    for (std::size_t i = 0; i < count; ++i) {
        auto const at = read.find("/solutions/" + std::to_string(i));
        if (at != read.end() && nameOf((*found)[i]) == shown[at->second].solution.name) {
            shown[at->second].index = i;
            taken[i] = true;
        }
    }
    std::map<std::string_view, std::deque<std::size_t>> left;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (!shown[i].index) {
            left[shown[i].solution.name].push_back(i);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        auto const name = taken[i] ? std::nullopt : nameOf((*found)[i]);
        auto const at = name ? left.find(*name) : left.end();
        if (at != left.end() && !at->second.empty()) {
            shown[at->second.front()].index = i;
            at->second.pop_front();
        }
    }
    if (std::all_of(shown.begin(), shown.end(), [](ShownSolution const& one) { return one.index; })) {
        std::sort(shown.begin(), shown.end(),
                  [](ShownSolution const& a, ShownSolution const& b) { return *a.index < *b.index; });
    }
    return shown;
}

/// Moves a solution to where another one is; nothing if the file has changed since it was read.
void moveSolutionTo(EditParts& parts, ShownSolution const& one, ShownSolution const& other) {
    if (one.index && other.index) {
        parts.run([&](Json const& level) { return edit::moveSolution(level, *one.index, *other.index); });
    }
}

/// The solution as the file has it now; nullptr if it has been renamed or removed since it was read.
Json const* statedSolution(EditParts const& parts, std::string const& name) {
    auto const list = parts.tree().find("solutions");
    if (list == parts.tree().end() || !list->is_array()) {
        return nullptr;
    }
    auto const found =
        std::find_if(list->begin(), list->end(), [&](Json const& entry) { return nameOf(entry) == name; });
    return found == list->end() ? nullptr : &*found;
}

void drawSolution(EditParts& parts, std::vector<ShownSolution> const& all, std::size_t index) {
    Solution const& solution = all[index].solution;
    std::size_t const count = all.size();
    std::string const item = "solution " + std::to_string(index);
    std::string name = solution.name;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - (count > 1 ? orderArrowsWidth() : 0));
    if (committedText(parts, item, name)) {
        bool const renamed =
            parts.run([&](Json const& level) { return edit::renameSolution(level, solution.name, name); });
        if (renamed && parts.entries.solution == solution.name) {
            parts.entries.solution = name;
        }
    }
    if (count > 1) {
        if (auto const to = orderArrows(parts, item, index, count)) {
            moveSolutionTo(parts, all[index], all[*to]);
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
    bool const shows = parts.entries.solution == solution.name;
    char const* const label = shows ? words::hideEntries : words::showEntries;
    besideIfRoom(label);
    if (smallButton(parts, label, item + " entries", words::entriesTip)) {
        parts.entries.solution = shows ? std::string() : solution.name;
        parts.entries.first.clear();
    }
    if (Json const* const stated = shows ? statedSolution(parts, solution.name) : nullptr) {
        drawSolutionEntries(parts, solution.name, *stated);
    }
    ImGui::Separator();
}

} // namespace

void drawSolutionsPage(EditParts& parts) {
    if (parts.level.solutions.empty()) {
        caption(words::noSolutions);
    }
    std::vector<ShownSolution> const solutions = shownSolutions(parts);
    for (std::size_t i = 0; i < solutions.size(); ++i) {
        // By its name, so that the ring of the keyboard stays with a solution that is moved.
        ImGui::PushID(solutions[i].solution.name.c_str());
        drawSolution(parts, solutions, i);
        ImGui::PopID();
    }
    if (smallButton(parts, words::recordNew, "record new", words::recordNewTip)) {
        actions::testPlay(parts);
    }
}

} // namespace trembler::ui
