#include "puzzle/edit/commands/objects.hpp"

#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/tree/part_statements.hpp"
#include "puzzle/edit/tree/reference_owners.hpp"
#include "puzzle/edit/tree/references.hpp"
#include "puzzle/edit/tree/subset.hpp"
#include "puzzle/edit/tree/tree_access.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::edit {
namespace {

using NameSet = std::set<std::string>;

NameSet setOf(std::vector<std::string> const& names) {
    return {names.begin(), names.end()};
}

/// Removes the entries of a list for which `gone` is true, and the list if it is empty then and was not
/// before.
template <class Gone>
void removeFrom(Json& level, char const* key, Gone const& gone) {
    auto const found = level.find(key);
    if (found == level.end() || !found->is_array() || found->empty()) {
        return;
    }
    Json kept = Json::array();
    for (Json& entry : *found) {
        if (!gone(entry)) {
            kept.push_back(std::move(entry));
        }
    }
    *found = std::move(kept);
    dropIfEmpty(level, key);
}

bool refersTo(Json& joint, NameSet const& names, ReferenceOwners const& owners) {
    bool found = false;
    forReferencesOf(joint,
                    [&](Json const& name) { found = found || owners.among(names, name.get<std::string>()); });
    return found;
}

} // namespace

std::vector<std::string> objectNames(Json const& level) {
    std::vector<std::string> names;
    if (Json const* const list = findList(level, "objects")) {
        for (Json const& entry : *list) {
            if (std::string name = textOf(entry, "name"); !name.empty()) {
                names.push_back(std::move(name));
            }
        }
    }
    return names;
}

Json const* findObject(Json const& level, std::string const& name) {
    if (Json const* const list = findList(level, "objects")) {
        for (Json const& entry : *list) {
            if (!name.empty() && textOf(entry, "name") == name) {
                return &entry;
            }
        }
    }
    return nullptr;
}

std::string freeName(Json const& level, std::string const& wanted) {
    return untaken(takenNames(level), wanted);
}

Command addObject(Json const& level, NewObject const& object) {
    std::string const wanted = object.name.empty() ? object.part : object.name;
    std::string const name = freeName(level, wanted);
    mustBeName(name, "the name of an object");
    if (object.properties.is_null() == false && !object.properties.is_object()) {
        throw CommandError("the properties of an object must be an object");
    }
    Json entry{{"name", name}};
    if (!object.part.empty()) {
        entry["part"] = object.part;
    }
    setPlace(entry, object.at);
    setAngle(entry, object.angleDegrees);
    if (object.properties.is_object() && !object.properties.empty()) {
        entry["properties"] = object.properties;
    }
    return {fmt::format("Add {}", name),
            [entry](Json& tree) { listIn(tree, "objects").push_back(entry); },
            {name}};
}

void removeEntries(GameData const& data, Json& level, std::vector<std::string> const& names) {
    NameSet gone = setOf(names);
    ReferenceOwners const owners(data, level); // of the level with the objects that go
    removeFrom(level, "objects", [&](Json const& entry) { return gone.contains(textOf(entry, "name")); });
    // A gear refers to joints: joints that refer to a removed joint are removed as well.
    for (std::size_t before = 0; before != gone.size();) {
        before = gone.size();
        removeFrom(level, "joints", [&](Json& joint) {
            bool const isGone = refersTo(joint, gone, owners);
            if (std::string name = textOf(joint, "name"); isGone && !name.empty()) {
                gone.insert(std::move(name));
            }
            return isGone;
        });
    }
    removeFrom(level, "connections", [&](Json& connection) {
        Json const* const ends = endsOf(connection);
        return ends != nullptr && (owners.among(gone, (*ends)[0].get<std::string>()) ||
                                   owners.among(gone, (*ends)[1].get<std::string>()));
    });
    tidyEditorState(level);
}

Command removeObjects(GameData const& data, Json const& level, std::vector<std::string> const& names) {
    mustHaveObjects(level, names);
    std::vector<std::string> const free = unlocked(level, names);
    if (free.empty()) {
        throw CommandError(names.size() == 1 ? "the object is locked" : "the objects are locked");
    }
    return {fmt::format("Remove {}", objectsInWords(free)),
            [&data, free](Json& tree) { removeEntries(data, tree, free); }};
}

Command duplicateObjects(GameData const& data, Json const& level, std::vector<std::string> const& names,
                         Vec2 offset) {
    Json copies = subsetOf(data, level, names);
    std::vector<std::string> const made = makeUnique(data, copies, level);
    shiftSubset(copies, offset);
    return {fmt::format("Duplicate {}", objectsInWords(names)),
            [copies](Json& tree) { addSubset(tree, copies); }, made};
}

Command renameObject(GameData const& data, Json const& level, std::string const& name,
                     std::string const& to) {
    mustHaveObjects(level, {name});
    mustBeName(to, "the name of an object");
    if (to != name && takenNames(level).contains(to)) {
        throw CommandError(fmt::format("the name '{}' is taken", to));
    }
    return {fmt::format("Rename {} to {}", name, to),
            [&data, name, to](Json& tree) {
                Json& entry = objectEntry(tree, name);
                NewNames names{{name, to}};
                PartStatements parts(data);
                renameInsides(parts, entry, to, names);
                entry["name"] = to;
                renameInEntries(data, tree, names);
                renameElsewhere(tree, names);
            },
            {to}};
}

Command renameJoint(GameData const& data, Json const& level, std::size_t joint, std::string const& to) {
    mustHaveEntry(level, "joints", joint, "joint");
    mustBeName(to, "the name of a joint");
    std::string const before = textOf(level["joints"][joint], "name");
    if (to != before && takenNames(level).contains(to)) {
        throw CommandError(fmt::format("the name '{}' is taken", to));
    }
    return {fmt::format("Rename joint to {}", to), [&data, joint, before, to](Json& tree) {
                static std::vector<std::string> const order{"name", "form"};
                setMember(entryIn(tree, "joints", joint), "name", to, order);
                if (!before.empty()) {
                    NewNames const names{{before, to}};
                    renameInEntries(data, tree, names);
                    renameElsewhere(tree, names);
                }
            }};
}

Command setPart(Json const& level, std::vector<std::string> const& names, std::string const& part) {
    mustHaveObjects(level, names);
    return {part.empty() ? fmt::format("Detach {} from its part", objectsInWords(names))
                         : fmt::format("Make {} from {}", objectsInWords(names), part),
            [names, part](Json& tree) {
                for (std::string const& name : names) {
                    Json& entry = objectEntry(tree, name);
                    if (part.empty()) {
                        entry.erase("part");
                    } else {
                        setObjectMember(entry, "part", part);
                    }
                }
            },
            names};
}

Command setFlipped(Json const& level, std::vector<std::string> const& names, bool flipped) {
    mustHaveObjects(level, names);
    std::string const words = objectsInWords(names);
    return {flipped ? fmt::format("Flip {}", words) : fmt::format("Flip {} back", words),
            [names, flipped](Json& tree) {
                for (std::string const& name : names) {
                    Json& entry = objectEntry(tree, name);
                    if (flipped) {
                        setObjectMember(entry, "flipped", true);
                    } else {
                        entry.erase("flipped");
                    }
                }
            },
            names};
}

} // namespace trembler::edit
