#include "game/ui/edit/goals/goal_fields.hpp"

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/goals/goal_words.hpp"
#include "game/ui/edit/view/edit_geometry.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/tree/part_statements.hpp"
#include "puzzle/goals/reading/condition_outline.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace trembler::ui {
namespace {

using edit::Json;

/// Marks a part among the choices of objects; no name contains it.
constexpr char anyOfPart = '\x01';
constexpr std::array<char const*, 3> quantities{"at_least", "at_most", "exactly"};

/// The choice that stands for one object, or for any object of a part.
std::string choiceOf(Json const& one) {
    if (one.is_object() && one.contains("part") && one["part"].is_string()) {
        return anyOfPart + one["part"].get<std::string>();
    }
    return one.is_string() ? one.get<std::string>() : std::string();
}

bool oneObjectField(EditParts& parts, Json& one, std::string const& item) {
    std::vector<std::string> choices = edit::namesOfObjectsAndPieces(*parts.data, parts.tree());
    choices.emplace_back("it");
    for (std::string const& part : parts.data->parts.names()) {
        choices.push_back(anyOfPart + part);
    }
    std::string chosen = choiceOf(one);
    auto const inWords = [&](std::string const& choice) {
        return choice.front() == anyOfPart
                   ? shownGoalWord("part") + ": " + parts.catalog().titleOf(choice.substr(1))
                   : choice;
    };
    if (!choiceField(parts, item, chosen, choices, inWords) || chosen.empty()) {
        return false;
    }
    one = chosen.front() == anyOfPart ? Json{{"part", chosen.substr(1)}} : Json(chosen);
    return true;
}

/// One object, any of a part, or several of both.
bool selectorField(EditParts& parts, std::string const& key, Json& value, std::string const& item) {
    bool changed = false;
    if (!value.is_array()) {
        fieldName(shownGoalWord(key), "");
        changed = oneObjectField(parts, value, item);
        if (smallButton(parts, words::listOfObjects, item + " several", words::listOfObjectsTip)) {
            value = Json::array({value});
            changed = true;
        }
        return changed;
    }
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < value.size(); ++i) {
        std::string const inner = item + "/" + std::to_string(i);
        fieldName(shownGoalWord(key), "");
        changed = oneObjectField(parts, value[i], inner) || changed;
        if (smallButton(parts, words::removeIt, inner + " remove")) {
            removed = i;
        }
    }
    if (removed && value.size() > 1) {
        value.erase(*removed);
        changed = true;
    } else if (removed) { // a list cannot be empty: one object is as good
        Json const last = value[0];
        value = last;
        return true;
    }
    if (smallButton(parts, words::oneMore, item + " more")) {
        std::vector<std::string> const names = edit::objectNames(parts.tree());
        auto const fresh = std::find_if(names.begin(), names.end(), [&](std::string const& name) {
            return std::find(value.begin(), value.end(), Json(name)) == value.end();
        });
        if (fresh != names.end()) {
            value.push_back(*fresh);
            changed = true;
        }
    }
    return changed;
}

bool areaOfScene(EditParts& parts, Json& value, std::string const& item) {
    for (SceneArea const& area : sceneAreas(parts)) {
        if (area.kind == EntryKind::goalArea && area.path == parts.goalPlace) {
            if (auto const changed = areaFields(parts, area.area, item)) {
                value = edit::areaJson(*changed);
                return true;
            }
        }
    }
    return false;
}

/// A text or a choice that may be left out.
bool optionalField(EditParts& parts, Json& body, std::string const& key, std::string const& item,
                   std::vector<std::string> const& choices = {}) {
    auto const stated = body.find(key);
    std::string text = stated != body.end() && stated->is_string() ? stated->get<std::string>() : "";
    fieldName(shownGoalWord(key), "");
    bool const changed = choices.empty() ? committedText(parts, item, text)
                                         : choiceField(parts, item, text, choices, shownGoalWord);
    if (changed && text.empty()) {
        body.erase(key);
    } else if (changed) {
        body[key] = text;
    }
    return changed;
}

/// A number of a unit that its schema names, between its limits.
bool quantityField(EditParts& parts, Json& body, std::string const& key, Json const& schema) {
    double value = body.contains(key) && body[key].is_number() ? body[key].get<double>() : 1;
    fieldName(shownGoalWord(key), "");
    if (!numberField(parts, "goal " + key, value, schema["minimum"].get<double>(),
                     schema["maximum"].get<double>(), schema.value("description", ""))) {
        return false;
    }
    body[key] = value;
    return true;
}

/// How many a count demands: one of three keys, which keeps its place.
bool quantityFields(EditParts& parts, Json& body) {
    std::string key = quantities.front();
    std::int64_t number = 1;
    for (char const* const quantity : quantities) {
        if (body.contains(quantity)) {
            key = quantity;
            number = body[quantity].is_number() ? static_cast<std::int64_t>(body[quantity].get<double>()) : 1;
        }
    }
    std::string chosen = key;
    auto amount = static_cast<double>(number);
    fieldName(shownGoalWord("count"), "");
    bool changed =
        choiceField(parts, "goal quantity", chosen, {quantities.begin(), quantities.end()}, shownGoalWord);
    fieldName("", "");
    double const least = chosen == quantities.front() ? 1 : 0;
    changed = numberField(parts, "goal number", amount, least, 100000, "", true) || changed;
    if (!changed) {
        return false;
    }
    Json const value = static_cast<std::int64_t>(std::max(amount, least));
    Json made = Json::object();
    bool placed = false;
    for (auto const& member : body.items()) {
        bool const ofQuantity =
            std::find(quantities.begin(), quantities.end(), member.key()) != quantities.end();
        if (!ofQuantity) {
            made[member.key()] = member.value();
        } else if (!std::exchange(placed, true)) {
            made[chosen] = value;
        }
    }
    if (!placed) {
        made[chosen] = value;
    }
    body = std::move(made);
    return true;
}

/// A field for each member of a condition's value, by the member's schema, in the schema's order. Inner
/// conditions have lines of their own.
bool memberFields(EditParts& parts, Json& body, Json const& members) {
    bool changed = false;
    bool counted = false;
    std::size_t index = 0;
    for (auto const& member : members.items()) {
        std::string const& key = member.key();
        Json const& schema = member.value();
        std::string const item = "goal/" + std::to_string(index++);
        std::string const type = schema.value("type", "");
        if (isSelector(schema)) {
            changed = (body.contains(key) && selectorField(parts, key, body[key], item)) || changed;
        } else if (isArea(schema)) {
            changed = (body.contains(key) && areaOfScene(parts, body[key], item)) || changed;
        } else if (schema.contains("enum")) {
            std::vector<std::string> choices{""}; // left out
            for (Json const& choice : schema["enum"]) {
                choices.push_back(choice.get<std::string>());
            }
            changed = optionalField(parts, body, key, "goal " + key, choices) || changed;
        } else if (type == "string") {
            changed = optionalField(parts, body, key, "goal " + key) || changed;
        } else if (type == "number") {
            changed = quantityField(parts, body, key, schema) || changed;
        } else if (type == "integer" && !std::exchange(counted, true)) {
            changed = quantityFields(parts, body) || changed;
        }
    }
    return changed;
}

} // namespace

bool goalFields(EditParts& parts, std::string const& kind, Json& body) {
    ConditionOutline const* const outline = findOutline(kind);
    if (outline == nullptr) {
        return false;
    }
    Json const& schema = outline->schema;
    if (isSelector(schema)) {
        return selectorField(parts, "object", body, "goal");
    }
    if (schema.contains("items") && isSelector(schema["items"])) {
        bool changed = false;
        for (std::size_t i = 0; body.is_array() && i < body.size(); ++i) {
            changed = selectorField(parts, "object", body[i], "goal/" + std::to_string(i)) || changed;
        }
        return changed;
    }
    return schema.contains("properties") && body.is_object() &&
           memberFields(parts, body, schema["properties"]);
}

} // namespace trembler::ui
