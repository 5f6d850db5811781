// Part definitions, from which the objects in the toolbox are made.
#pragma once

#include "runtime/level/json/json_document.hpp"
#include "runtime/level/model/entries.hpp"
#include "runtime/level/model/part_group.hpp"
#include "runtime/level/model/translation.hpp"
#include "runtime/level/property/name_table.hpp"
#include "runtime/level/property/property_set.hpp"
#include "runtime/world/registry.hpp"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler {

/// One object, or a composite of several, which may be composites themselves.
struct PartDefinition {
    std::string name;  ///< by which levels refer to it, for example "steel bar"
    std::string title; ///< for players
    std::string text;  ///< for players: its function
    /// Of a composite: of its main piece, in addition to the properties that the piece states.
    PropertySet properties;
    std::shared_ptr<JsonDocument const> document; ///< may be null
    Translations texts{};                         ///< in further languages
    /// As the file states them; none: they follow from the properties (puzzle/data/part_groups.hpp).
    std::optional<std::vector<PartGroup>> groups{};

    std::string main{};                         ///< name of the main piece; empty: the first
    std::vector<LevelObject> objects{};         ///< the pieces of a composite; none: it is one object
    std::vector<LevelJoint> joints{};           ///< between pieces, or of a piece and the world
    std::vector<LevelConnection> connections{}; ///< between pieces
    NameTable names{};                          ///< of the pieces that properties refer to

    [[nodiscard]] bool composite() const { return !objects.empty(); }
    /// Of a composite only.
    [[nodiscard]] std::string const& mainPiece() const { return main.empty() ? objects.front().name : main; }
    /// The prototype for making objects while the world runs. Of a composite: of `properties` alone; see
    /// pieceProperties() for all of them.
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

} // namespace trembler
