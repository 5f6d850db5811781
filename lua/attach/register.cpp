#include "lua/attach/register.hpp"

#include "lua/attach/parameter_value.hpp"
#include "lua/attach/scripts_property.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace trembler::lua {
namespace {

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
    auto const fault = faultOf(*parameter, valueOf(setting, *parameter));
    return fault ? std::optional(fmt::format("'{}' of '{}' is {}", parameter->name, manifest.name, *fault))
                 : std::nullopt;
}

std::optional<std::string> faultOf(Scripts const& scripts, LiveScripts const* known) {
    if (known == nullptr) {
        return std::string("the level names no mod under \"mods\" that has scripts");
    }
    std::vector<std::string> names;
    for (auto const& script : known->all()) {
        if (script->script().manifest.attached) {
            names.push_back(script->name());
        }
    }
    std::vector<std::string> seen;
    for (ScriptUse const& use : scripts.uses) {
        LiveScript const* const script = known->find(use.script);
        if (script == nullptr || !script->script().manifest.attached) {
            return fmt::format("there is no script '{}' that objects can name{}; {}", use.script,
                               didYouMean(use.script, names),
                               names.empty() ? "the level's mods have none"
                                             : fmt::format("there are {}", listed(names)));
        }
        if (std::find(seen.begin(), seen.end(), use.script) != seen.end()) {
            return fmt::format("the script '{}' is named twice", use.script);
        }
        seen.push_back(use.script);
        for (ScriptSetting const& setting : use.settings) {
            if (auto fault = faultOf(setting, script->script().manifest)) {
                return fault;
            }
        }
    }
    return std::nullopt;
}

void addRule(Registry& registry, std::shared_ptr<LiveScripts const> const& known) {
    registry.rule({.property = &propertyInfo<Scripts>(),
                   .check =
                       [known](Store const& store, ObjectId id) {
                           return faultOf(*store.findColumn<Scripts>()->find(id), known.get());
                       },
                   .checkAll = nullptr});
}

} // namespace

void registerScripts(Registry& registry) {
    registry.property<Scripts>();
    addRule(registry, nullptr);
}

std::shared_ptr<LiveScripts const> registerMods(Registry& registry, std::span<Mod const> mods,
                                                std::shared_ptr<ScriptLog> const& log, Problems& problems) {
    if (mods.empty()) {
        registerScripts(registry);
        return std::make_shared<LiveScripts const>(Vocabulary(registry));
    }
    registry.property<Scripts>();
    auto const scripts = std::make_shared<LiveScripts>(Vocabulary(registry));
    std::map<std::string, std::string> taken; // names of components, and their files
    for (Registration const& registration : registry.components()) {
        taken.emplace(registration.info->text.name, "this program");
    }
    for (Mod const& mod : mods) {
        registry.extension(mod.name);
        for (Manifest const& manifest : mod.interactions) {
            if (manifest.name.empty()) {
                continue; // its errors have been reported
            }
            auto const [owner, isNew] = taken.emplace(manifest.name, fmt::format("the mod '{}'", mod.name));
            if (!isNew) {
                problems.add(manifest.problem(
                    "name", fmt::format("{} has an interaction '{}' already", owner->second, manifest.name),
                    "a name of its own"));
                continue;
            }
            std::size_t const before = problems.count();
            auto const script = declare(manifest, mod.name, scripts->vocabulary(), problems);
            if (problems.count() != before || !script->info) {
                continue;
            }
            auto const live = std::make_shared<LiveScript>(script, log);
            scripts->add(live);
            registry.component({&live->info(), [live] { return live->make(); }, nullptr});
        }
    }
    addRule(registry, scripts);
    return scripts;
}

} // namespace trembler::lua
