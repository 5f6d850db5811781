// A script whose names have been resolved: a component is made from it.
#pragma once

#include "lua/binding/vocabulary.hpp"
#include "lua/interaction/manifest.hpp"
#include "runtime/component/info.hpp"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace trembler::lua {

/// A property that a script reads, under the name by which it has declared it.
struct DeclaredProperty {
    std::string name;
    PropertyInfo const* info = nullptr;
    std::vector<FieldPlace> fields;

    [[nodiscard]] bool ofObjects() const { return info->kind == PropertyKind::object; }
    [[nodiscard]] FieldPlace const* field(std::string_view key) const;
    [[nodiscard]] std::vector<std::string> keys() const;
};

/// Constant once it is made; worlds share it.
struct Script {
    Manifest manifest;
    std::string effect; ///< of its ComponentInfo: the mod
    std::vector<DeclaredProperty> reads;
    std::vector<std::size_t> first;  ///< places in reads: properties of an object, or of the first of a pair
    std::vector<std::size_t> second; ///< properties of the second of a pair
    RoleInfo const* role = nullptr;
    std::set<std::string, std::less<>> words; ///< all words in its text
    std::unique_ptr<ComponentInfo> info;      ///< refers to texts in this Script

    [[nodiscard]] DeclaredProperty const* read(std::string_view name) const;
    [[nodiscard]] std::vector<std::string> readNames() const;
};

/// Finds the properties and the resolver that a manifest names. Adds unknown names to `problems`, with file,
/// line and a suggestion; the script is then not to be used.
[[nodiscard]] std::shared_ptr<Script const> declare(Manifest manifest, std::string effect,
                                                    Vocabulary const& vocabulary, Problems& problems);

} // namespace trembler::lua
