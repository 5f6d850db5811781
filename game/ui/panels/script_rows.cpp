#include "game/ui/panels/script_rows.hpp"

#include "game/ui/shared/parameter_widgets.hpp"
#include "lua/attach/parameter_value.hpp"

namespace trembler::ui {
namespace {

/// Without its manifest a setting does not say which of its values counts: the one that is not the initial.
lua::Value valueStated(lua::ScriptSetting const& setting) {
    lua::ScriptSetting const initial;
    if (!setting.text.empty()) {
        return setting.text;
    }
    if (setting.on) {
        return setting.on;
    }
    if (setting.vector != initial.vector) {
        return setting.vector;
    }
    return setting.number;
}

} // namespace

std::vector<InspectorRow> scriptRows(lua::Scripts const& scripts, lua::LiveScripts const* known) {
    std::vector<InspectorRow> rows;
    for (lua::ScriptUse const& use : scripts.uses) {
        lua::LiveScript const* const script = known == nullptr ? nullptr : known->find(use.script);
        if (script == nullptr) {
            rows.push_back({use.script, {}, {}, {}});
            for (lua::ScriptSetting const& setting : use.settings) {
                rows.push_back({spokenName(setting.parameter), valueInWords(valueStated(setting)), {}, {}});
            }
            continue;
        }
        lua::Manifest const& manifest = script->script().manifest;
        rows.push_back({use.script, manifest.text, {}, {}});
        for (lua::Parameter const& parameter : manifest.parameters) {
            rows.push_back({spokenName(parameter.name), valueInWords(lua::valueFor(&use, parameter)),
                            parameter.unit, parameter.text});
        }
    }
    return rows;
}

} // namespace trembler::ui
