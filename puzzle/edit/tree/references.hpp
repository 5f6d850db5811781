// The references to objects in a level: in joints, connections, properties, goals, recorded inputs and
// groups.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"

#include <map>
#include <string>

namespace trembler::edit {

using NewNames = std::map<std::string, std::string>; // by the old ones

/// Renames the references in entries of "joints", "connections" and "properties" of objects. `entries` is a
/// level, or anything with these lists.
void renameInEntries(GameData const& data, Json& entries, NewNames const& names);
/// The same in goals, the inputs of solutions, and the editor's own data.
void renameElsewhere(Json& level, NewNames const& names);

/// Calls `visit` with each name of an object that a joint states.
template <class Joint, class Visit>
void forReferencesOf(Joint& joint, Visit&& visit) {
    if (!joint.is_object()) {
        return;
    }
    for (char const* const key : {"a", "b", "joint_a", "joint_b"}) {
        if (auto const found = joint.find(key); found != joint.end() && found->is_string()) {
            visit(*found);
        }
    }
}
/// The two names of a connection; nullptr if it is of another form.
template <class Connection>
[[nodiscard]] Connection* endsOf(Connection& connection) {
    Connection* ends = &connection;
    if (connection.is_object()) {
        auto const between = connection.find("between");
        ends = between == connection.end() ? nullptr : &*between;
    }
    bool const good = ends != nullptr && ends->is_array() && ends->size() == 2 && (*ends)[0].is_string() &&
                      (*ends)[1].is_string();
    return good ? ends : nullptr;
}

} // namespace trembler::edit
