// Part definitions, from which the objects in the toolbox are made.
#pragma once

#include "runtime/level/json/json_document.hpp"
#include "runtime/level/model/translation.hpp"
#include "runtime/level/property/property_set.hpp"
#include "runtime/world/registry.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace trembler {

struct PartDefinition {
    std::string name;  ///< by which levels refer to it, for example "steel bar"
    std::string title; ///< for players
    std::string text;  ///< for players: its function
    PropertySet properties;
    std::shared_ptr<JsonDocument const> document; ///< may be null
    Translations texts{};                         ///< in further languages

    /// The prototype for making objects while the world runs.
    [[nodiscard]] Prototype prototype() const;
};

/// All parts, in order of their names.
class PartLibrary {
public:
    /// Adds a part; throws InputError if there is one of that name.
    void add(PartDefinition part);
    [[nodiscard]] PartDefinition const* find(std::string const& name) const;
    [[nodiscard]] std::vector<PartDefinition const*> all() const;
    [[nodiscard]] std::vector<std::string> names() const;

private:
    std::map<std::string, PartDefinition> parts_;
};

/// Reads one part definition. Throws InputError.
[[nodiscard]] PartDefinition readPart(Registry const& registry,
                                      std::shared_ptr<JsonDocument const> const& document);
/// Reads every *.json file of a folder. Throws InputError with the problems of all files.
[[nodiscard]] PartLibrary loadParts(Registry const& registry, std::filesystem::path const& folder);

} // namespace trembler
