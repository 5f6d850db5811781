// A level as its file states it: plain data that an editor can copy and change. Independent of physics.
#pragma once

#include "runtime/input/player_input.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/model/entries.hpp"
#include "runtime/level/model/recorded_change.hpp"
#include "runtime/level/model/teaching_step.hpp"
#include "runtime/level/model/tool_count.hpp"
#include "runtime/level/model/translation.hpp"
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

/// The kind of the connections that a player may lay.
inline constexpr std::string_view playersWire = "wire";

/// A part and the place where a player put it.
struct Placement {
    std::string part;
    Vec2 at;          ///< m
    double angle = 0; ///< rad
    std::string path; ///< in the file, for messages; empty if the player placed it
    /// Mirrored about its own vertical axis, before it is turned.
    bool flipped = false;
};

/// An entry of "toolbox".
struct ToolboxEntry {
    std::string part;
    int count = 1; ///< may be unlimitedCount
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
    int hand = 0; ///< 0 or 1: grab, move, release
};

/// A recorded run: its placements, inputs and changes, and whether it is expected to solve the level.
struct Solution {
    std::string name;
    std::vector<Placement> placements;
    std::vector<LevelConnection> wires;  ///< that the player laid; also between placed parts
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
    int wires = 0; ///< that the player may lay: the entry {"wire": n} of "toolbox"; may be unlimitedCount
    nlohmann::json goals; ///< null if there are none; puzzle/goals reads them
    nlohmann::json
        task; ///< of a demonstration: the condition that its player is to reach; null if there is none
    std::vector<std::string> hints;
    std::vector<TeachingStep> teaching; ///< the steps of a beginner's first lesson, in this order
    Translations texts;                 ///< in further languages
    std::vector<Solution> solutions;
    nlohmann::json editor; ///< the level editor's own data, see read_editor.hpp; null if it has none

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
