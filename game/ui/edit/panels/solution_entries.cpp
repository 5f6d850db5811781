#include "game/ui/edit/panels/solution_entries.hpp"

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/shared/words.hpp"
#include "puzzle/edit/commands/solutions.hpp"
#include "puzzle/edit/tree/part_statements.hpp"
#include "puzzle/goals/level_schema.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using namespace render;
using edit::Json;

/// A run with a hand that moves has hundreds of inputs.
constexpr std::size_t shownAtOnce = 12;

/// The names that the entries of a solution may state.
edit::EntryNames namesFor(EditParts& parts, std::string const& solution) {
    edit::EntryNames names;
    if (auto const tools = parts.tree().find("toolbox"); tools != parts.tree().end() && tools->is_array()) {
        for (Json const& tool : *tools) {
            if (tool.is_object() && tool.contains("part") && tool["part"].is_string()) {
                names.parts.push_back(tool["part"].get<std::string>());
            }
        }
    }
    names.objects = edit::namesOfObjectsAndPieces(*parts.data, parts.tree());
    std::vector<std::string> placed = edit::placedNames(parts.tree(), solution);
    std::sort(placed.begin(), placed.end());
    edit::PartStatements statements(*parts.data);
    for (std::string const& name : placed) {
        if (name.empty()) {
            continue;
        }
        names.objects.push_back(name);
        for (edit::PartPiece const& piece : statements.pieces(name.substr(0, name.rfind(' ')))) {
            names.objects.push_back(name + " " + piece.name);
        }
    }
    return names;
}

/// The fields of one entry; the entry as the designer changes it in this picture.
void drawEntry(EditParts& parts, std::string const& solution, edit::EntryList const& list, std::size_t index,
               Json const& entry, edit::EntryNames const& names, std::size_t count) {
    std::string const item = list.key + " " + std::to_string(index);
    edit::EntryForm const* const form = list.formOf(entry);
    ImGui::PushID(item.c_str());
    ImGui::Text("%zu. %s", index + 1,
                form == nullptr || form->key.empty() ? "" : shownField(words::capital(form->key)).c_str());
    auto const change = [&](edit::InspectedField const& field, Json const& value) {
        Json const changed = edit::entryWith(entry, field, value);
        runWidget(
            parts,
            [&](Json const& level) {
                return edit::setSolutionEntry(level, solution, list.key, index, changed);
            },
            isContinuous(field));
    };
    if (form != nullptr) {
        for (edit::InspectedField const& field : edit::fieldsOfEntry(*form, entry, names)) {
            if (auto const value = fieldWidget(parts, field, item + field.place)) {
                change(field, *value);
            }
        }
    }
    if (smallButton(parts, words::removeIt, item + " remove")) {
        parts.run(
            [&](Json const& level) { return edit::removeSolutionEntry(level, solution, list.key, index); });
    }
    if (auto const to = orderArrows(parts, item, index, count)) {
        parts.run([&](Json const& level) {
            return edit::moveSolutionEntry(level, solution, list.key, index, *to);
        });
    }
    ImGui::PopID();
}

/// Which entries of a long list are shown.
std::size_t firstShown(EditParts& parts, std::string const& list, std::size_t count) {
    if (count <= shownAtOnce) {
        return 0;
    }
    std::size_t& first = parts.entries.first[list];
    first = std::min(first, count - 1);
    auto from = static_cast<double>(first + 1);
    fieldName(words::entriesFrom, words::entriesFromTip);
    if (numberField(parts, list + " from", from, 1, static_cast<double>(count), "", true)) {
        first = static_cast<std::size_t>(from) - 1;
    }
    return first;
}

void drawAdd(EditParts& parts, std::string const& solution, edit::EntryList const& list,
             edit::EntryNames const& names) {
    edit::EntryForm const* chosen = nullptr;
    std::string const item = "add " + list.key;
    if (list.forms.size() == 1) {
        if (smallButton(parts, words::addEntry, item)) {
            chosen = &list.forms.front();
        }
    } else {
        std::vector<std::string> kinds;
        for (edit::EntryForm const& form : list.forms) {
            kinds.push_back(form.key);
        }
        std::string kind;
        fieldName(words::addEntry, "");
        if (choiceField(parts, item, kind, kinds,
                        [](std::string const& key) { return shownField(words::capital(key)); })) {
            chosen = &*std::find_if(list.forms.begin(), list.forms.end(),
                                    [&](edit::EntryForm const& form) { return form.key == kind; });
        }
    }
    if (chosen == nullptr) {
        return;
    }
    Json const entry = edit::newEntry(*chosen, names, parts.middleOfView());
    bool const done = parts.run(
        [&](Json const& level) { return edit::addSolutionEntry(level, solution, list.key, entry); });
    if (done) {
        parts.entries.first[list.key] = static_cast<std::size_t>(-1); // the last one, which is the new one
    }
}

} // namespace

void drawSolutionEntries(EditParts& parts, std::string const& solution, Json const& stated) {
    if (parts.entries.listsOf != parts.data.get()) {
        parts.entries.lists = edit::solutionLists(levelSchema(parts.data->registry));
        parts.entries.listsOf = parts.data.get();
    }
    Json const shown = stated; // a copy, as a widget changes the tree
    edit::EntryNames const names = namesFor(parts, solution);
    for (edit::EntryList const& list : parts.entries.lists) {
        ImGui::PushID(list.key.c_str());
        ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::accent));
        ImGui::TextUnformatted(shownField(words::capital(list.key)).c_str());
        ImGui::PopStyleColor();
        Json const entries =
            shown.contains(list.key) && shown[list.key].is_array() ? shown[list.key] : Json::array();
        std::size_t const first = firstShown(parts, list.key, entries.size());
        for (std::size_t i = first; i < std::min(entries.size(), first + shownAtOnce); ++i) {
            drawEntry(parts, solution, list, i, entries[i], names, entries.size());
        }
        drawAdd(parts, solution, list, names);
        ImGui::PopID();
    }
}

} // namespace trembler::ui
