#include "puzzle/edit/tree/subset.hpp"

#include "puzzle/edit/tree/part_statements.hpp"
#include "puzzle/edit/tree/reference_owners.hpp"
#include "puzzle/edit/tree/references.hpp"
#include "puzzle/edit/tree/tree_access.hpp"

#include <algorithm>

namespace trembler::edit {
namespace {

/// A list of a level; an empty one if there is none.
Json const& entriesOf(Json const& level, char const* key) {
    static Json const none = Json::array();
    Json const* const list = findList(level, key);
    return list == nullptr ? none : *list;
}

bool isAmong(Json const& joint, std::set<std::string> const& names, ReferenceOwners const& owners) {
    bool all = joint.is_object();
    forReferencesOf(joint,
                    [&](Json const& name) { all = all && owners.among(names, name.get<std::string>()); });
    return all;
}

void addPart(Json& to, char const* key, Json list) {
    if (!list.empty()) {
        to[key] = std::move(list);
    }
}

void shiftPoint(Json& entry, char const* key, Vec2 by) {
    if (auto const found = entry.find(key); found != entry.end()) {
        if (auto const point = pointOf(*found)) {
            *found = pointJson(*point + by);
        }
    }
}

} // namespace

Json subsetOf(GameData const& data, Json const& level, std::vector<std::string> const& names) {
    mustHaveObjects(level, names);
    std::set<std::string> const wanted(names.begin(), names.end());
    std::set<std::string> known = wanted;
    Json subset = Json::object();
    Json objects = Json::array();
    for (Json const& entry : entriesOf(level, "objects")) {
        if (wanted.contains(textOf(entry, "name"))) {
            objects.push_back(entry);
        }
    }
    subset["objects"] = std::move(objects);
    ReferenceOwners const owners(data, level);
    Json const& joints = entriesOf(level, "joints");
    std::vector<bool> taken(joints.size(), false);
    for (bool more = true; more;) { // a gear is among them once its joints are
        more = false;
        for (std::size_t i = 0; i < joints.size(); ++i) {
            if (!taken[i] && isAmong(joints[i], known, owners)) {
                taken[i] = more = true;
                if (std::string name = textOf(joints[i], "name"); !name.empty()) {
                    known.insert(std::move(name));
                }
            }
        }
    }
    Json among = Json::array();
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (taken[i]) {
            among.push_back(joints[i]);
        }
    }
    addPart(subset, "joints", std::move(among));
    Json connections = Json::array();
    for (Json const& connection : entriesOf(level, "connections")) {
        Json const* const ends = endsOf(connection);
        if (ends != nullptr && owners.among(wanted, (*ends)[0].get<std::string>()) &&
            owners.among(wanted, (*ends)[1].get<std::string>())) {
            connections.push_back(connection);
        }
    }
    addPart(subset, "connections", std::move(connections));
    Json groups = Json::array();
    auto const editor = level.find("editor");
    Json const none;
    for (Json const& group : entriesOf(editor == level.end() ? none : *editor, "groups")) {
        bool const inside =
            group.is_array() && std::all_of(group.begin(), group.end(), [&](Json const& name) {
                return name.is_string() && wanted.contains(name.get<std::string>());
            });
        if (inside) {
            groups.push_back(group);
        }
    }
    addPart(subset, "groups", std::move(groups));
    return subset;
}

std::vector<std::string> makeUnique(GameData const& data, Json& subset, Json const& level) {
    std::set<std::string> taken = takenNames(level);
    NewNames renamed;
    std::vector<std::string> made;
    PartStatements parts(data);
    for (char const* const key : {"objects", "joints"}) {
        if (!subset.contains(key)) {
            continue;
        }
        for (Json& entry : subset[key]) {
            std::string const name = textOf(entry, "name");
            if (name.empty()) {
                continue; // a joint without a name
            }
            std::string const free = untaken(taken, name);
            taken.insert(free);
            renamed[name] = free;
            if (std::string_view(key) == "objects") {
                made.push_back(free);
                renameInsides(parts, entry, free, renamed);
            }
            entry["name"] = free;
        }
    }
    renameInEntries(data, subset, renamed);
    if (subset.contains("groups")) {
        for (Json& group : subset["groups"]) {
            for (Json& name : group) {
                auto const found = name.is_string() ? renamed.find(name.get<std::string>()) : renamed.end();
                if (found != renamed.end()) {
                    name = found->second;
                }
            }
        }
    }
    return made;
}

void shiftJoint(Json& joint, Vec2 a, Vec2 b) {
    if (!joint.is_object()) {
        return;
    }
    shiftPoint(joint, "at", a);
    shiftPoint(joint, "at_b", b);
    if (a == b) {
        shiftPoint(joint, "ground_a", a);
        shiftPoint(joint, "ground_b", b);
    }
}

void shiftSubset(Json& subset, Vec2 by) {
    for (Json& entry : subset["objects"]) {
        setPlace(entry, placeOf(entry) + by);
    }
    if (subset.contains("joints")) {
        for (Json& joint : subset["joints"]) {
            shiftJoint(joint, by, by);
        }
    }
}

void addSubset(Json& level, Json const& subset) {
    for (char const* const key : {"objects", "joints", "connections"}) {
        if (!subset.contains(key)) {
            continue;
        }
        Json& list = listIn(level, key);
        for (Json const& entry : subset[key]) {
            list.push_back(entry);
        }
    }
    if (subset.contains("groups")) {
        Json& editor = objectIn(level, "editor");
        static std::vector<std::string> const order{"groups", "locked", "hidden"};
        if (!editor.contains("groups")) {
            setMember(editor, "groups", Json::array(), order);
        }
        for (Json const& group : subset["groups"]) {
            editor["groups"].push_back(group);
        }
    }
}

} // namespace trembler::edit
