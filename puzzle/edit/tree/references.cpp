#include "puzzle/edit/tree/references.hpp"

#include "puzzle/edit/tree/tree_access.hpp"
#include "puzzle/goals/reading/condition_outline.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/property/idle_visitor.hpp"

#include <algorithm>

namespace trembler::edit {
namespace {

void renameText(Json& text, NewNames const& names) {
    if (text.is_string()) {
        if (auto const found = names.find(text.get_ref<std::string const&>()); found != names.end()) {
            text = found->second;
        }
    }
}

/// Renames the objects that the fields of a property refer to, by the property's description: it walks
/// through a value and its text at once.
class ReferenceRenamer final : public IdleVisitor {
public:
    ReferenceRenamer(Json& json, bool bare, NewNames const& names)
        : json_(json), bare_(bare), names_(names) {}

    void object(FieldInfo const& info, ObjectId& /*value*/) override {
        if (Json* const stated = find(info)) {
            renameText(*stated, names_);
        }
    }
    void list(FieldInfo const& info, ListField& field) override {
        Json* const stated = find(info);
        if (stated == nullptr || !stated->is_array() || stated->size() > info.most) {
            return;
        }
        field.resize(stated->size());
        for (std::size_t i = 0; i < stated->size(); ++i) {
            ReferenceRenamer inner((*stated)[i], !field.elementsHaveFields(), names_);
            field.visitElement(i, inner);
        }
    }

private:
    [[nodiscard]] Json* find(FieldInfo const& info) {
        if (bare_) {
            return &json_;
        }
        if (!json_.is_object()) {
            return nullptr;
        }
        auto const found = json_.find(std::string(info.key));
        return found == json_.end() ? nullptr : &*found;
    }

    Json& json_;
    bool bare_;
    NewNames const& names_;
};

void renameInProperties(GameData const& data, Json& properties, NewNames const& names) {
    for (auto const& item : properties.items()) {
        PropertyInfo const* const info = data.registry.objectProperty(item.key());
        if (info == nullptr) {
            continue;
        }
        auto const value = info->makeValue();
        ReferenceRenamer renamer(item.value(), isBare(outlineOf(*value)), names);
        value->visit(renamer);
    }
}

/// A name, or a list of names and {"part": ...}.
void renameSelector(Json& selector, NewNames const& names) {
    renameText(selector, names);
    if (selector.is_array()) {
        for (Json& single : selector) {
            renameText(single, names);
        }
    }
}

void renameInSolution(Json& solution, NewNames const& names) {
    if (auto const wires = solution.is_object() ? solution.find("wires") : solution.end();
        wires != solution.end() && wires->is_array()) {
        for (Json& wire : *wires) {
            renameSelector(wire, names);
        }
    }
    auto const inputs = solution.is_object() ? solution.find("inputs") : solution.end();
    if (inputs == solution.end() || !inputs->is_array()) {
        return;
    }
    for (Json& input : *inputs) {
        if (!input.is_object()) {
            continue;
        }
        for (char const* const key : {"grab", "remove", "cut"}) {
            if (auto const found = input.find(key); found != input.end()) {
                renameSelector(*found, names);
            }
        }
    }
}

/// Steps name objects, but where a part is placed that part.
void renameInTeaching(Json& step, NewNames const& names) {
    if (!step.is_object()) {
        return;
    }
    for (char const* const key : {"wire", "grab", "cut"}) {
        if (auto const found = step.find(key); found != step.end()) {
            renameSelector(*found, names);
        }
    }
}

} // namespace

void renameInEntries(GameData const& data, Json& entries, NewNames const& names) {
    if (auto const objects = entries.find("objects"); objects != entries.end() && objects->is_array()) {
        for (Json& entry : *objects) {
            auto const stated = entry.is_object() ? entry.find("properties") : entry.end();
            if (stated != entry.end() && stated->is_object()) {
                renameInProperties(data, *stated, names);
            }
            auto const pieces = entry.is_object() ? entry.find("pieces") : entry.end();
            if (pieces == entry.end() || !pieces->is_object()) {
                continue;
            }
            for (auto const& piece : pieces->items()) {
                if (piece.value().is_object()) {
                    renameInProperties(data, piece.value(), names);
                }
            }
        }
    }
    if (auto const joints = entries.find("joints"); joints != entries.end() && joints->is_array()) {
        for (Json& joint : *joints) {
            forReferencesOf(joint, [&](Json& name) { renameText(name, names); });
        }
    }
    if (auto const list = entries.find("connections"); list != entries.end() && list->is_array()) {
        for (Json& connection : *list) {
            if (Json* const ends = endsOf(connection)) {
                renameText((*ends)[0], names);
                renameText((*ends)[1], names);
            }
        }
    }
}

void renameElsewhere(Json& level, NewNames const& names) {
    for (char const* const key : {"goals", "task"}) {
        if (auto const goals = level.find(key); goals != level.end()) {
            forSelectors(*goals, [&](Json& selector) { renameSelector(selector, names); });
        }
    }
    if (auto const steps = level.find("teaching"); steps != level.end() && steps->is_array()) {
        for (Json& step : *steps) {
            renameInTeaching(step, names);
        }
    }
    if (auto const list = level.find("solutions"); list != level.end() && list->is_array()) {
        for (Json& solution : *list) {
            renameInSolution(solution, names);
        }
    }
    auto const editor = level.find("editor");
    if (editor == level.end() || !editor->is_object()) {
        return;
    }
    for (auto const& item : editor->items()) {
        if (item.value().is_array()) {
            for (Json& entry : item.value()) {
                renameSelector(entry, names);
            }
        }
    }
}

} // namespace trembler::edit
