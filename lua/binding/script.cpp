#include "lua/binding/script.hpp"

#include "lua/attach/scripts_property.hpp"
#include "lua/component/scripted_interaction.hpp"
#include "lua/sandbox/source/source_check.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::lua {
namespace {

class Declaring {
public:
    Declaring(Script& script, Vocabulary const& vocabulary, Problems& problems)
        : script_(script), vocabulary_(vocabulary), problems_(problems) {}

    void declareAll() {
        Manifest const& manifest = script_.manifest;
        script_.role = vocabulary_.role(manifest.calls);
        if (script_.role == nullptr && !manifest.calls.empty()) {
            auto const known = vocabulary_.roleNames();
            problems_.add(manifest.problem(manifest.calls,
                                           fmt::format("there is no resolver '{}' to call{}", manifest.calls,
                                                       didYouMean(manifest.calls, known)),
                                           listed(known)));
        }
        for (std::string const& name : manifest.reads) {
            (void)find(name);
        }
        for (std::string const& name : manifest.first) {
            needOfObjects(name, script_.first);
        }
        for (std::string const& name : manifest.second) {
            needOfObjects(name, script_.second);
        }
        if (manifest.attached) {
            addOwn(propertyInfo<Scripts>());
        }
        if (manifest.application == Application::pairs) {
            addOwn(manifest.touching ? propertyInfo<Contacts>() : propertyInfo<Position>());
        }
    }

private:
    // The place in reads of a property that the script states, or nothing.
    std::optional<std::size_t> find(std::string const& name) {
        for (std::size_t i = 0; i < script_.reads.size(); ++i) {
            if (script_.reads[i].name == name) {
                return i;
            }
        }
        if (std::find(refused_.begin(), refused_.end(), name) != refused_.end()) {
            return std::nullopt; // 'reads' and a selection may both name it; one message is enough
        }
        PropertyInfo const* const info = vocabulary_.property(name);
        if (info == nullptr) {
            refused_.push_back(name);
            auto const known = vocabulary_.propertyNames();
            problems_.add(script_.manifest.problem(
                name, fmt::format("there is no property '{}'{}", name, didYouMean(name, known)),
                "the name of a property, or its key in level files"));
            return std::nullopt;
        }
        if (info->fields == nullptr && info->kind != PropertyKind::object) {
            refused_.push_back(name);
            problems_.add(script_.manifest.problem(
                name, fmt::format("the property '{}' has no fields that a script could read", name),
                "a property with described fields"));
            return std::nullopt;
        }
        add(name, *info);
        return script_.reads.size() - 1;
    }
    void add(std::string name, PropertyInfo const& info) {
        script_.reads.push_back(
            {.name = std::move(name),
             .info = &info,
             .fields = info.fields == nullptr ? std::vector<FieldPlace>() : info.fields()});
    }
    // Properties that the host itself reads for the script, under names that no script can write.
    void addOwn(PropertyInfo const& info) { add("", info); }
    void needOfObjects(std::string const& name, std::vector<std::size_t>& list) {
        auto const at = find(name);
        if (!at) {
            return;
        }
        if (!script_.reads[*at].ofObjects()) {
            problems_.add(script_.manifest.problem(name, fmt::format("no object has '{}'", name),
                                                   "a property of objects"));
            return;
        }
        list.push_back(*at);
    }

    Script& script_;
    Vocabulary const& vocabulary_;
    Problems& problems_;
    std::vector<std::string> refused_; // names of properties that a message was made for
};

std::vector<PropertyInfo const*> infosOf(Script const& script, std::vector<std::size_t> const& reads) {
    std::vector<PropertyInfo const*> all;
    for (std::size_t const read : reads) {
        if (std::find(all.begin(), all.end(), script.reads[read].info) == all.end()) {
            all.push_back(script.reads[read].info);
        }
    }
    return all;
}

std::unique_ptr<ComponentInfo> infoOf(Script const& script) {
    auto made = std::make_unique<ComponentInfo>(
        ComponentInfo{.type = typeid(ScriptedInteraction),
                      .kind = ComponentKind::interaction,
                      .text = {.name = script.manifest.name,
                               .effect = script.effect,
                               .level = "",
                               .work = script.manifest.text.empty() ? std::string_view("As its script says.")
                                                                    : script.manifest.text}});
    for (DeclaredProperty const& property : script.reads) {
        if (std::find(made->reads.begin(), made->reads.end(), property.info) == made->reads.end()) {
            made->reads.push_back(property.info);
        }
    }
    made->role = script.role->type;
    made->roleName = script.role->name;
    for (auto const* list : {&script.first, &script.second}) {
        for (std::size_t const i : *list) {
            PropertyInfo const* const needed = script.reads[i].info;
            if (std::find(made->neededAll.begin(), made->neededAll.end(), needed) == made->neededAll.end()) {
                made->neededAll.push_back(needed);
            }
        }
    }
    if (script.manifest.attached) {
        made->neededAll.push_back(&propertyInfo<Scripts>());
    }
    if (script.manifest.application == Application::pairs) {
        made->pairs = {.first = infosOf(script, script.first), .second = infosOf(script, script.second)};
        if (script.manifest.attached) { // the first names the script
            made->pairs->first.push_back(&propertyInfo<Scripts>());
        }
    }
    made->hashesMemory = true;
    return made;
}

} // namespace

FieldPlace const* DeclaredProperty::field(std::string_view key) const {
    auto const at = std::find_if(fields.begin(), fields.end(),
                                 [&](FieldPlace const& place) { return place.info.key == key; });
    return at == fields.end() ? nullptr : &*at;
}

std::vector<std::string> DeclaredProperty::keys() const {
    std::vector<std::string> all;
    for (FieldPlace const& place : fields) {
        all.emplace_back(place.info.key);
    }
    return all;
}

DeclaredProperty const* Script::read(std::string_view name) const {
    auto const at = std::find_if(reads.begin(), reads.end(), [&](DeclaredProperty const& property) {
        return !name.empty() && property.name == name;
    });
    return at == reads.end() ? nullptr : &*at;
}

std::vector<std::string> Script::readNames() const {
    std::vector<std::string> all;
    for (DeclaredProperty const& property : reads) {
        if (!property.name.empty()) {
            all.push_back(property.name);
        }
    }
    return all;
}

std::shared_ptr<Script const> declare(Manifest manifest, std::string effect, Vocabulary const& vocabulary,
                                      Problems& problems) {
    auto const script = std::make_shared<Script>();
    std::size_t const before = problems.count();
    script->manifest = std::move(manifest);
    script->effect = std::move(effect);
    script->words = wordsOf(script->manifest.source);
    Declaring(*script, vocabulary, problems).declareAll();
    if (problems.count() == before && script->role != nullptr) {
        script->info = infoOf(*script);
    }
    return script;
}

} // namespace trembler::lua
