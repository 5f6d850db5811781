#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/fields/property_rows.hpp"
#include "game/ui/shared/parameter_widgets.hpp"
#include "lua/attach/live_script.hpp"
#include "lua/attach/parameter_value.hpp"
#include "puzzle/edit/commands/properties.hpp"

namespace trembler::ui {
namespace {

using edit::Json;

/// The value that a use of a script, as files state it, gives a parameter.
lua::Value statedValue(Json const& use, lua::Parameter const& parameter) {
    if (!use.contains("set") || !use["set"].is_array()) {
        return parameter.initial;
    }
    for (Json const& setting : use["set"]) {
        if (!setting.is_object() || setting.value("param", "") != parameter.name) {
            continue;
        }
        if (std::holds_alternative<double>(parameter.initial) && setting.contains("number")) {
            return setting["number"].get<double>();
        }
        if (std::holds_alternative<bool>(parameter.initial) && setting.contains("on")) {
            return setting["on"].get<bool>();
        }
        if (std::holds_alternative<std::string>(parameter.initial) && setting.contains("text")) {
            return setting["text"].get<std::string>();
        }
        if (std::holds_alternative<Vec2>(parameter.initial) && setting.contains("vector") &&
            setting["vector"].size() == 2) {
            return Vec2{setting["vector"][0].get<double>(), setting["vector"][1].get<double>()};
        }
    }
    return parameter.initial;
}

Json settingJson(std::string const& name, lua::Value const& value) {
    Json setting = Json::object();
    setting["param"] = name;
    if (double const* const number = std::get_if<double>(&value)) {
        setting["number"] = *number;
    } else if (bool const* const on = std::get_if<bool>(&value)) {
        setting["on"] = *on;
    } else if (Vec2 const* const vector = std::get_if<Vec2>(&value)) {
        setting["vector"] = Json::array({vector->x, vector->y});
    } else {
        setting["text"] = std::get<std::string>(value);
    }
    return setting;
}

void state(Json& use, std::string const& name, lua::Value const& value) {
    if (!use.contains("set") || !use["set"].is_array()) {
        use["set"] = Json::array();
    }
    for (Json& setting : use["set"]) {
        if (setting.is_object() && setting.value("param", "") == name) {
            setting = settingJson(name, value);
            return;
        }
    }
    use["set"].push_back(settingJson(name, value));
}

/// One script in use: its name, its parameters, and a button that takes it away. True when it was changed.
bool drawUse(EditParts& parts, Json& uses, std::size_t index) {
    Json& use = uses[index];
    std::string const name = use.is_object() ? use.value("script", "") : "";
    ImGui::TextWrapped("%s", name.c_str());
    ImGui::SameLine();
    if (smallButton(parts, words::removeShort, "remove script " + name, words::removeIt)) {
        uses.erase(index);
        return true;
    }
    lua::LiveScript const* const script = parts.data->scripts->find(name);
    if (script == nullptr) {
        return false;
    }
    bool changed = false;
    for (lua::Parameter const& parameter : script->script().manifest.parameters) {
        auto const value = parameterWidget(parts.context.layout, parameter, statedValue(use, parameter),
                                           parameter.name + " of " + name);
        if (ImGui::IsItemActivated()) {
            parts.widget = {parts.document.newGesture(), edit::Gesture::Next::replaces};
        }
        if (value) {
            state(use, parameter.name, *value);
            changed = true;
        }
    }
    return changed;
}

} // namespace

void drawScripts(EditParts& parts, edit::InspectedProperty const* property) {
    if (parts.data->scripts == nullptr || parts.data->scripts->all().empty()) {
        return;
    }
    Json uses = property != nullptr && !property->fields.empty() && property->fields[0].value.is_array()
                    ? property->fields[0].value
                    : Json::array();
    pageHeading(words::scriptsHeading);
    bool changed = false;
    for (std::size_t i = 0; i < uses.size() && !changed; ++i) {
        ImGui::PushID(static_cast<int>(i));
        changed = drawUse(parts, uses, i);
        ImGui::PopID();
    }
    std::vector<std::string> names;
    for (auto const& script : parts.data->scripts->all()) {
        if (script->script().manifest.attached) {
            names.push_back(script->name());
        }
    }
    std::string chosen = words::addScript;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (choiceField(parts, "add script", chosen, names)) {
        uses.push_back(Json{{"script", chosen}});
        changed = true;
        parts.widget = {};
    }
    if (!changed) {
        return;
    }
    runWidget(
        parts,
        [&](Json const& level) {
            std::string const& piece = parts.selection.piece();
            return uses.empty()
                       ? edit::removeProperty(*parts.data, level, parts.selected(), "scripts", piece)
                       : edit::setField(*parts.data, level, parts.selected(), "scripts", "", uses, piece);
        },
        true);
}

} // namespace trembler::ui
