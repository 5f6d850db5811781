// Reads "objects", "joints" and "connections": of a level, or of a part that is made of pieces.
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/model/entries.hpp"
#include "runtime/level/property/name_table.hpp"
#include "runtime/world/registry.hpp"

#include <map>
#include <string>
#include <vector>

namespace trembler {

/// Complains about wrong entries through their nodes, and leaves them out. The registry and the table, to
/// which it adds all names that properties refer to, must outlive it.
class EntryReader {
public:
    EntryReader(Registry const& registry, NameTable& names) : registry_(registry), names_(names) {}

    [[nodiscard]] std::vector<LevelObject> objects(JsonNode const& node);
    [[nodiscard]] std::vector<LevelJoint> joints(JsonNode const& node);
    [[nodiscard]] std::vector<LevelConnection> connections(JsonNode const& node);
    /// The place in the file of every name of an object or a joint.
    [[nodiscard]] std::map<std::string, std::string> const& paths() const { return paths_; }

private:
    /// Records a name; complains if it is taken.
    void takeName(JsonNode const& node, std::string const& name);
    [[nodiscard]] std::optional<LevelObject> object(JsonNode const& node);
    /// Reads one member of an object's entry, other than its name; false if the key is unknown.
    bool member(LevelObject& object, std::string const& key, JsonNode const& node);
    [[nodiscard]] std::optional<LevelJoint> joint(JsonNode const& node);
    [[nodiscard]] std::optional<LevelConnection> connection(JsonNode const& node);

    Registry const& registry_;
    NameTable& names_;
    std::map<std::string, std::string> paths_;
};

} // namespace trembler
