// Commands that connect objects: joints, and connections such as wires.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/math/vec2.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace trembler::edit {

/// A joint or a connection of a level, for selecting it.
struct JointEntry {
    std::size_t index = 0; ///< in "joints"
    std::string name;      ///< as stated, or as the world will name it ("joint 1")
    std::string form;
    std::string a;
    std::string b; ///< empty: the world
    Vec2 at;       ///< m
    Vec2 atB;      ///< m; that of `at` if the form has none
};
struct ConnectionEntry {
    std::size_t index = 0; ///< in "connections"
    std::string a;
    std::string b;
    std::string kind; ///< as stated; may be empty
};
/// Those of a level that can be read; others are left out.
[[nodiscard]] std::vector<JointEntry> jointsOf(Json const& level);
[[nodiscard]] std::vector<ConnectionEntry> connectionsOf(Json const& level);

/// Adds a joint of a form ("hinge", "rope" ...) between two objects, or, with an empty `b`, from an object to
/// the world. `at` and `atB` are m, in the world; `atB` is only stated for forms that have it. Checked by the
/// file's reader, as all values are: throws CommandError.
[[nodiscard]] Command addJoint(GameData const& data, Json const& level, std::string const& form,
                               std::string const& a, std::string const& b, Vec2 at, Vec2 atB);
/// Removes joints by their indices. Gears that refer to them are removed as well.
[[nodiscard]] Command removeJoints(GameData const& data, Json const& level,
                                   std::vector<std::size_t> const& joints);
/// Moves the point `field` ("at", "at_b", "ground_a", "ground_b") of a joint, m.
[[nodiscard]] Command moveJointPoint(Json const& level, std::size_t joint, std::string const& field, Vec2 to);

/// Connects two objects; without a kind, by the only effect that can. Throws CommandError if they are
/// connected already, are the same, or do not exist.
[[nodiscard]] Command addConnection(Json const& level, std::string const& a, std::string const& b,
                                    std::string const& kind = {});
[[nodiscard]] Command removeConnections(Json const& level, std::vector<std::size_t> const& connections);
/// Puts other objects at the ends of a connection, or states another kind; an empty kind leaves it open.
[[nodiscard]] Command changeConnection(Json const& level, std::size_t connection, std::string const& a,
                                       std::string const& b, std::string const& kind);

} // namespace trembler::edit
