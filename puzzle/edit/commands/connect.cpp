#include "puzzle/edit/commands/connect.hpp"

#include "puzzle/edit/commands/properties.hpp"
#include "puzzle/edit/tree/references.hpp"
#include "puzzle/edit/tree/subset.hpp"
#include "puzzle/edit/tree/tree_access.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace trembler::edit {
namespace {

constexpr std::array<std::string_view, 4> formsWithTwoEnds{"distance", "rope", "spring", "pulley"};

bool statesTwoEnds(std::string_view form) {
    return std::find(formsWithTwoEnds.begin(), formsWithTwoEnds.end(), form) != formsWithTwoEnds.end();
}

/// Whether a name is that of something inside an object that is made from a part: "door coil".
bool isInsideAnObject(Json const& level, std::string const& name) {
    Json const* const list = findList(level, "objects");
    return list != nullptr && std::any_of(list->begin(), list->end(), [&](Json const& entry) {
               std::string const object = textOf(entry, "name");
               return !object.empty() && !textOf(entry, "part").empty() && name.starts_with(object + " ");
           });
}

/// Pieces of composite parts may be ends; whether a part has them is a question for the list of problems.
void mustBeEnds(Json const& level, std::string const& a, std::string const& b) {
    for (std::string const& name : {a, b}) {
        if (!isInsideAnObject(level, name)) {
            mustHaveObjects(level, {name});
        }
    }
    if (a == b) {
        throw CommandError(fmt::format("'{}' cannot be connected with itself", a));
    }
}

void mustBeNew(Json const& level, std::string const& a, std::string const& b, std::string const& kind,
               std::optional<std::size_t> except) {
    for (ConnectionEntry const& other : connectionsOf(level)) {
        bool const same = (other.a == a && other.b == b) || (other.a == b && other.b == a);
        if (same && other.kind == kind && other.index != except) {
            throw CommandError(fmt::format("'{}' and '{}' are connected already", a, b));
        }
    }
}

Json connectionJson(std::string const& a, std::string const& b, std::string const& kind) {
    Json pair = Json::array({a, b});
    return kind.empty() ? pair : Json{{"between", std::move(pair)}, {"kind", kind}};
}

/// The first hinge or slider whose first object is this one. Throws CommandError if there is none.
std::string turningJointOf(Json const& level, std::string const& object) {
    for (JointEntry const& joint : jointsOf(level)) {
        if (joint.a == object && (joint.form == "hinge" || joint.form == "slider")) {
            return joint.name;
        }
    }
    throw CommandError(fmt::format(
        "a gear couples what turns or slides: '{}' needs a hinge or a slider first, of which it is object a",
        object));
}

/// What a joint of this form cannot do without, besides its objects and places: values that the author will
/// change, so that the joint works as soon as it is drawn.
void completeJoint(Json const& level, Json& joint, std::string const& form, std::string const& a,
                   std::string const& b, Vec2 at, Vec2 atB) {
    if (form == "pulley") { // its wheels hang above the ends until the author moves them
        double const top = std::max(at.y, atB.y) + 1;
        joint["ground_a"] = pointJson({at.x, top});
        joint["ground_b"] = pointJson({atB.x, top});
    } else if (form == "spring") {
        joint["stiffness"] = 100;
        joint["damping_rate"] = 2;
    } else if (form == "wheel") {
        joint["axis"] = pointJson({0, 1});
        joint["stiffness"] = 1000;
        joint["damping_rate"] = 50;
    } else if (form == "gear") {
        if (b.empty()) {
            throw CommandError("a gear couples two objects: it cannot go to the world");
        }
        joint["joint_a"] = turningJointOf(level, a);
        joint["joint_b"] = turningJointOf(level, b);
    }
}

std::string countInWords(std::size_t count, std::string_view one, char const* several) {
    return count == 1 ? std::string(one) : fmt::format(fmt::runtime(several), count);
}

} // namespace

std::vector<JointEntry> jointsOf(Json const& level) {
    std::vector<JointEntry> joints;
    Json const* const list = findList(level, "joints");
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
        Json const& joint = (*list)[i];
        if (!joint.is_object()) {
            continue;
        }
        auto const pointUnder = [&](char const* key) {
            auto const found = joint.find(key);
            return found == joint.end() ? std::nullopt : pointOf(*found);
        };
        JointEntry entry{i,
                         textOf(joint, "name"),
                         textOf(joint, "form"),
                         textOf(joint, "a"),
                         textOf(joint, "b"),
                         pointUnder("at").value_or(Vec2{}),
                         {}};
        entry.atB = statesTwoEnds(entry.form) ? pointUnder("at_b").value_or(Vec2{}) : entry.at;
        if (entry.name.empty()) {
            entry.name = fmt::format("joint {}", i + 1);
        }
        joints.push_back(std::move(entry));
    }
    return joints;
}

std::vector<ConnectionEntry> connectionsOf(Json const& level) {
    std::vector<ConnectionEntry> connections;
    Json const* const list = findList(level, "connections");
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
        if (Json const* const ends = endsOf((*list)[i])) {
            connections.push_back({i, (*ends)[0].get<std::string>(), (*ends)[1].get<std::string>(),
                                   textOf((*list)[i], "kind")});
        }
    }
    return connections;
}

Command addJoint(GameData const& data, Json const& level, std::string const& form, std::string const& a,
                 std::string const& b, Vec2 at, Vec2 atB) {
    if (!isInsideAnObject(level, a)) {
        mustHaveObjects(level, {a});
    }
    if (!b.empty()) {
        mustBeEnds(level, a, b);
    }
    Json joint{{"name", untaken(takenNames(level), form.empty() ? "joint" : form + " of " + a)},
               {"form", form},
               {"a", a}};
    if (!b.empty()) {
        joint["b"] = b;
    }
    joint["at"] = pointJson(at);
    if (statesTwoEnds(form)) {
        joint["at_b"] = pointJson(atB);
    }
    completeJoint(level, joint, form, a, b, at, atB);
    mustBeJoint(data, joint);
    return {fmt::format("Add {} of {}", form, b.empty() ? a : fmt::format("{} and {}", a, b)),
            [joint](Json& tree) { listIn(tree, "joints").push_back(joint); }};
}

Command removeJoints(GameData const& data, Json const& level, std::vector<std::size_t> const& joints) {
    if (joints.empty()) {
        throw CommandError("no joint is selected");
    }
    for (std::size_t const joint : joints) {
        mustHaveEntry(level, "joints", joint, "joint");
    }
    std::set<std::size_t> const gone(joints.begin(), joints.end());
    return {fmt::format("Remove {}", countInWords(gone.size(), "joint", "{} joints")),
            [&data, gone](Json& tree) {
                mustHaveEntry(tree, "joints", *gone.rbegin(), "joint");
                std::vector<std::string> names;
                Json kept = Json::array();
                Json& list = tree["joints"];
                for (std::size_t i = 0; i < list.size(); ++i) {
                    if (!gone.contains(i)) {
                        kept.push_back(std::move(list[i]));
                    } else if (std::string name = textOf(list[i], "name"); !name.empty()) {
                        names.push_back(std::move(name));
                    }
                }
                list = std::move(kept);
                dropIfEmpty(tree, "joints");
                removeEntries(data, tree, names); // the gears that refer to them
            }};
}

Command moveJointPoint(Json const& level, std::size_t joint, std::string const& field, Vec2 to) {
    mustHaveEntry(level, "joints", joint, "joint");
    if (field != "at" && field != "at_b" && field != "ground_a" && field != "ground_b") {
        throw CommandError(fmt::format("a joint has no point '{}'", field));
    }
    return {"Move joint", [joint, field, point = pointJson(to)](Json& tree) {
                entryIn(tree, "joints", joint)[field] = point;
            }};
}

Command addConnection(Json const& level, std::string const& a, std::string const& b,
                      std::string const& kind) {
    mustBeEnds(level, a, b);
    mustBeNew(level, a, b, kind, {});
    return {fmt::format("Connect {} and {}", a, b),
            [made = connectionJson(a, b, kind)](Json& tree) { listIn(tree, "connections").push_back(made); }};
}

Command removeConnections(Json const& level, std::vector<std::size_t> const& connections) {
    if (connections.empty()) {
        throw CommandError("no connection is selected");
    }
    for (std::size_t const connection : connections) {
        mustHaveEntry(level, "connections", connection, "connection");
    }
    std::set<std::size_t> const gone(connections.begin(), connections.end());
    return {fmt::format("Remove {}", countInWords(gone.size(), "connection", "{} connections")),
            [gone](Json& tree) {
                mustHaveEntry(tree, "connections", *gone.rbegin(), "connection");
                for (auto index = gone.rbegin(); index != gone.rend(); ++index) {
                    tree["connections"].erase(*index);
                }
                dropIfEmpty(tree, "connections");
            }};
}

Command changeConnection(Json const& level, std::size_t connection, std::string const& a,
                         std::string const& b, std::string const& kind) {
    mustHaveEntry(level, "connections", connection, "connection");
    mustBeEnds(level, a, b);
    mustBeNew(level, a, b, kind, connection);
    return {"Change connection", [connection, made = connectionJson(a, b, kind)](Json& tree) {
                entryIn(tree, "connections", connection) = made;
            }};
}

} // namespace trembler::edit
