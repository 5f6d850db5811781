#include "lua/attach/register.hpp"

#include "lua/attach/scripts_property.hpp"
#include "lua/binding/script.hpp"
#include "lua/component/scripted_interaction.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace trembler::lua {
namespace {

using ScriptsByName = std::map<std::string, std::shared_ptr<Script const>>;

std::optional<std::string> faultOf(ScriptSetting const& setting, Manifest const& manifest) {
    Parameter const* const parameter = manifest.parameter(setting.parameter);
    if (parameter == nullptr) {
        std::vector<std::string> known;
        for (Parameter const& each : manifest.parameters) {
            known.push_back(each.name);
        }
        return fmt::format("'{}' has no parameter '{}'{}; it has {}", manifest.name, setting.parameter,
                           didYouMean(setting.parameter, known), known.empty() ? "none" : listed(known));
    }
    if (std::holds_alternative<double>(parameter->initial) &&
        !(setting.number >= parameter->minimum && setting.number <= parameter->maximum)) {
        return fmt::format("'{}' of '{}' is {} {}; expected \"number\" from {} to {}", parameter->name,
                           manifest.name, setting.number, parameter->unit, parameter->minimum,
                           parameter->maximum);
    }
    if (std::holds_alternative<std::string>(parameter->initial)) {
        if (setting.text.size() > longestText) {
            return fmt::format("'{}' of '{}' is a \"text\" of at most {} bytes", parameter->name,
                               manifest.name, longestText);
        }
        if (!parameter->choices.empty() && std::find(parameter->choices.begin(), parameter->choices.end(),
                                                     setting.text) == parameter->choices.end()) {
            return fmt::format("'{}' of '{}' is '{}'; expected {}", parameter->name, manifest.name,
                               setting.text, listed(parameter->choices));
        }
    }
    return std::nullopt;
}

std::optional<std::string> faultOf(Scripts const& scripts, ScriptsByName const& known) {
    std::vector<std::string> names;
    for (auto const& [name, script] : known) {
        if (script->manifest.attached) {
            names.push_back(name);
        }
    }
    std::vector<std::string> seen;
    for (ScriptUse const& use : scripts.uses) {
        auto const at = known.find(use.script);
        if (at == known.end() || !at->second->manifest.attached) {
            return fmt::format("there is no script '{}' that objects can name{}; {}", use.script,
                               didYouMean(use.script, names),
                               names.empty() ? "the level's mods have none" : "there are " + listed(names));
        }
        if (std::find(seen.begin(), seen.end(), use.script) != seen.end()) {
            return fmt::format("the script '{}' is named twice", use.script);
        }
        seen.push_back(use.script);
        for (ScriptSetting const& setting : use.settings) {
            if (auto fault = faultOf(setting, at->second->manifest)) {
                return fault;
            }
        }
    }
    return std::nullopt;
}

} // namespace

void registerMods(Registry& registry, std::span<Mod const> mods, std::shared_ptr<ScriptLog> const& log,
                  Problems& problems) {
    if (mods.empty()) {
        return;
    }
    registry.property<Scripts>();
    Vocabulary const vocabulary(registry);
    std::map<std::string, std::string> taken; // names of components, and who has them
    for (Registration const& registration : registry.components()) {
        taken.emplace(registration.info->text.name, "this program");
    }
    auto const byName = std::make_shared<ScriptsByName>();
    for (Mod const& mod : mods) {
        registry.extension(mod.name);
        for (Manifest const& manifest : mod.interactions) {
            if (manifest.name.empty()) {
                continue; // what is wrong with it has been said
            }
            auto const [owner, isNew] = taken.emplace(manifest.name, "the mod '" + mod.name + "'");
            if (!isNew) {
                problems.add(manifest.problem(
                    "name", fmt::format("{} has an interaction '{}' already", owner->second, manifest.name),
                    "a name of its own"));
                continue;
            }
            std::size_t const before = problems.count();
            auto const script = declare(manifest, mod.name, vocabulary, problems);
            if (problems.count() != before || !script->info) {
                continue;
            }
            byName->emplace(manifest.name, script);
            Registration made{script->info.get(),
                              [script, log]() -> std::unique_ptr<Component> {
                                  return std::make_unique<ScriptedInteraction>(script, log);
                              },
                              nullptr};
            registry.component(made);
        }
    }
    registry.rule(
        {.property = &propertyInfo<Scripts>(),
         .check = [byName](Store const& store,
                           ObjectId id) { return faultOf(*store.findColumn<Scripts>()->find(id), *byName); },
         .checkAll = nullptr});
}

} // namespace trembler::lua
