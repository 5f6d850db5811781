#include "lua/binding/vocabulary.hpp"

namespace trembler::lua {

Vocabulary::Vocabulary(Registry const& registry) {
    for (PropertyInfo const* info : registry.objectProperties()) {
        add(*info);
    }
    for (Registration const& registration : registry.components()) {
        ComponentInfo const& component = *registration.info;
        for (PropertyInfo const* info : component.offers) {
            add(*info);
        }
        if (component.roleInfo != nullptr && !component.roleInfo->calls.empty()) {
            roles_.emplace(component.roleInfo->name, component.roleInfo);
        }
    }
}

void Vocabulary::add(PropertyInfo const& info) {
    properties_.emplace(info.text.key, &info);
    properties_.emplace(info.text.name, &info);
}

PropertyInfo const* Vocabulary::property(std::string_view name) const {
    auto const at = properties_.find(name);
    return at == properties_.end() ? nullptr : at->second;
}

std::vector<std::string> Vocabulary::propertyNames() const {
    std::vector<std::string> names;
    names.reserve(properties_.size());
    for (auto const& [name, info] : properties_) {
        names.push_back(name);
    }
    return names;
}

RoleInfo const* Vocabulary::role(std::string_view name) const {
    auto const at = roles_.find(name);
    return at == roles_.end() ? nullptr : at->second;
}

std::vector<std::string> Vocabulary::roleNames() const {
    std::vector<std::string> names;
    for (auto const& [name, info] : roles_) {
        names.push_back(name);
    }
    return names;
}

} // namespace trembler::lua
