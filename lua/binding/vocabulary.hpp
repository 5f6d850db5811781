// The names that scripts use for properties and resolvers: made from the descriptions that a registry has.
#pragma once

#include "runtime/component/role_info.hpp"
#include "runtime/world/registry.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::lua {

/// A property has two names in scripts: its name in the thesis's notation, "Magnet on/off", and its key in
/// files, "magnet". A resolver has the name of its role.
class Vocabulary {
public:
    explicit Vocabulary(Registry const& registry);

    [[nodiscard]] PropertyInfo const* property(std::string_view name) const;
    /// The names of all properties, ascending.
    [[nodiscard]] std::vector<std::string> propertyNames() const;
    /// Finds only roles with functions that interactions may call.
    [[nodiscard]] RoleInfo const* role(std::string_view name) const;
    [[nodiscard]] std::vector<std::string> roleNames() const;

private:
    void add(PropertyInfo const& info);

    std::map<std::string, PropertyInfo const*, std::less<>> properties_;
    std::map<std::string, RoleInfo const*, std::less<>> roles_;
};

} // namespace trembler::lua
