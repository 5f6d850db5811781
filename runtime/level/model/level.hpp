// A level as its file states it: plain data that an editor can copy and change. Independent of physics.
#pragma once

#include "runtime/input/player_input.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/model/recorded_change.hpp"
#include "runtime/level/property/name_table.hpp"
#include "runtime/level/property/property_set.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

/// The version that this program writes; see migrations.hpp for how it reads older ones.
inline constexpr int levelVersion = 2;

/// An upright rectangle, in m.
struct Box {
    Vec2 corner; ///< lower left
    Vec2 size;   ///< both above zero

    bool operator==(Box const&) const = default;
    [[nodiscard]] bool contains(Vec2 p) const {
        return p.x >= corner.x && p.x <= corner.x + size.x && p.y >= corner.y && p.y <= corner.y + size.y;
    }
};

/// A rectangle [x, y, width, height] or a polygon [[x, y], ...] of at least three corners, in m.
struct Area {
    std::optional<Box> box;
    std::vector<Vec2> corners; ///< used if there is no box; may be concave

    bool operator==(Area const&) const = default;
    /// Whether the point lies inside or on the edge of a box; inside a polygon by the even-odd rule.
    [[nodiscard]] bool contains(Vec2 point) const;
};

/// An entry of "objects".
struct LevelObject {
    std::string name;
    std::string part;       ///< name of the part definition; empty: none
    PropertySet properties; ///< under "properties", and those of its placement ("at", "angle_deg")
    std::string path;       ///< in the file, for messages; empty if it is not from a file
};

/// An entry of "joints": an object whose property has the key "joint".
struct LevelJoint {
    std::string name; ///< as stated; empty: it gets one (jointNames())
    PropertySet properties;
    std::string path;
};

/// An entry of "connections".
struct LevelConnection {
    std::string a;
    std::string b;
    std::string path;
    std::string kind{}; ///< as stated, for example "wire"; empty: it follows from the objects connected
};

/// A part and the place where a player put it.
struct Placement {
    std::string part;
    Vec2 at;          ///< m
    double angle = 0; ///< rad
    std::string path; ///< in the file, for messages; empty if the player placed it
};

/// An entry of "toolbox".
struct ToolboxEntry {
    std::string part;
    int count = 1;
    std::string path;
};

/// A player input with the names of objects, as ids do not exist before the world.
struct RecordedInput {
    std::uint64_t frame = 1; ///< the frame that receives it, counted from 1
    PlayerInput::Kind kind = PlayerInput::Kind::release;
    std::string object;
    std::string other; ///< cut: the wire's other end
    Vec2 at;           ///< m, in the world: grab, move
    std::string path;
};

/// A recorded run: its placements, inputs and changes, and whether it is expected to solve the level.
struct Solution {
    std::string name;
    std::vector<Placement> placements;
    std::vector<RecordedInput> inputs;   ///< ascending by frame
    std::vector<RecordedChange> changes; ///< ascending by frame
    bool solves = true;                  ///< "expect": "solved" or "unsolved"
    std::optional<int> frames;           ///< how long to run it; none: the caller decides
    std::string path;
    /// The separate file that it was read from, for the places of problems; none: the level's file.
    std::shared_ptr<JsonDocument const> document{};
};

struct LevelFile {
    std::string title;
    std::string text;
    bool demonstration = false;    ///< must reach its goals without the player, like the thesis's experiments
    std::vector<std::string> mods; ///< the extensions that it needs
    PropertySet world;             ///< of the one object named "world"
    std::optional<Box> bounds;
    std::map<std::string, std::string> detail; ///< effect -> detail level
    std::vector<LevelObject> objects;
    std::vector<LevelJoint> joints;
    std::vector<LevelConnection> connections;
    std::optional<std::vector<Area>> placing; ///< none: anywhere within the bounds
    std::vector<ToolboxEntry> toolbox;
    nlohmann::json goals; ///< null if there are none; puzzle/goals reads them
    std::vector<std::string> hints;
    std::vector<Solution> solutions;
    nlohmann::json editor; ///< what the level editor keeps, see read_editor.hpp; null if nothing

    NameTable names; ///< of the objects that properties refer to
    /// The file that it was read from, for the places of problems that are found later; may be null.
    std::shared_ptr<JsonDocument const> document;

    [[nodiscard]] LevelObject const* findObject(std::string const& name) const;
    [[nodiscard]] Solution const* findSolution(std::string const& name) const;
    /// A problem with the value at `path`, with its place if the level came from a file.
    [[nodiscard]] Diagnostic diagnostic(std::string path, std::string message, std::string expected) const;
    /// The same for a value of a solution, which may have a separate file.
    [[nodiscard]] Diagnostic diagnostic(Solution const& solution, std::string path, std::string message,
                                        std::string expected) const;
};

} // namespace trembler
