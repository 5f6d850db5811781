// The fields of a table in a manifest: names, texts and flags, and their errors.
#pragma once

#include "lua/interaction/manifest.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::lua {

/// The messages about a list of texts; {} is its key.
struct NamesWords {
    std::string_view once;
    std::string_view wrong;
    std::string_view example;
};
inline constexpr NamesWords propertyWords{"every property once", "'{}' is no list of names of properties",
                                          "{} = {{ \"Position\", \"Velocity\" }}"};
inline constexpr NamesWords choiceWords{"every choice once", "'{}' is no list of at most 50 texts",
                                        "{} = {{ \"calm\", \"stormy\" }}"};

/// Reads single fields out of a manifest's tables (see treeOf()). Errors are added to the problems, at the
/// line of the wrong word in the manifest.
class ManifestFields {
public:
    /// Both must outlive it.
    ManifestFields(Manifest const& manifest, Problems& problems) : place_(manifest), problems_(problems) {}

    /// A problem at the line in which `word` stands.
    void complain(std::string_view word, std::string message, std::string expected) const;
    /// The same, where `word` first stands behind `table`.
    void complainIn(std::string_view table, std::string_view word, std::string message,
                    std::string expected) const;
    /// Reports every unknown key; `where` names the table, as in " in 'store'". Does nothing if it is no
    /// table.
    void onlyKeys(nlohmann::json const& table, std::string const& where,
                  std::vector<std::string> const& known) const;
    /// A text of 1 to `longest` bytes; empty if there is none.
    [[nodiscard]] std::string text(nlohmann::json const& table, char const* key, bool required,
                                   std::size_t longest) const;
    /// false if it is not stated.
    [[nodiscard]] bool flag(nlohmann::json const& table, char const* key) const;
    /// At most 50 different names; `key` is the key of the list.
    [[nodiscard]] std::vector<std::string> namesIn(nlohmann::json const& list, std::string_view key,
                                                   NamesWords const& words = propertyWords) const;
    /// The same for a key of a table; empty if it is not stated.
    [[nodiscard]] std::vector<std::string> names(nlohmann::json const& table, char const* key) const;

private:
    Manifest const& place_;
    Problems& problems_;
};

} // namespace trembler::lua
