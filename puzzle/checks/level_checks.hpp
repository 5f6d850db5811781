// All checks of a level before it runs: for verify, and for the editor while a level is edited.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/world/world.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace trembler {

/// The problems of a level, and how far it could be loaded.
struct LevelCheckup {
    /// In the order of the places in the files, at most Problems::most; empty if nothing is wrong.
    std::vector<Diagnostic> problems{};
    /// The things that this level still lacks to be finished: goals, solutions. It is playable without.
    std::vector<Diagnostic> lacking{};
    bool read = false;     ///< the file states a level
    bool playable = false; ///< and its world can be built and its goals judged: a session can be made of it
    bool crowded = false;  ///< but each frame takes long, see complainAboutCrowds()
};

/// Reads the level, builds its world, sets up its goals, and if all that is possible, looks for faults that
/// make it useless: placements of recorded solutions that it does not allow, objects out of bounds, a toolbox
/// out of reach, goals or a task that can never come true, materials of solids on liquids and the
/// other way round, and so many bodies in one place that it hardly
/// moves. Throws nothing but for lack of memory. `detail` overrides the detail levels that the level states.
[[nodiscard]] LevelCheckup checkWholeLevel(GameData const& data,
                                           std::shared_ptr<JsonDocument const> const& document,
                                           std::map<std::string, std::string> const& detail = {});

/// Complains about objects and areas that lie outside the level's bounds altogether, and about parts of the
/// toolbox for which there is no room in any area for placing. Objects without a shape and bodies of liquid
/// may lie anywhere. Room is searched for on a grid, so a part that a recorded solution places is taken to
/// have room. The world is that of the level, before its first frame.
void complainAboutReach(GameData const& data, LevelFile const& level, World const& world, Problems& problems);

/// Complains about goals, and a task, that can never come true, beyond those of which GoalJudge complains
/// because of the objects that they name: current where there is no source of it, fixed things that are to
/// touch one another, something without a body that is to move, and a goal together with its opposite. Does
/// not judge levels with mods, whose scripts may change everything. The world is that of the level, before
/// its first frame.
void complainAboutHopeless(GameData const& data, LevelFile const& level, World const& world,
                           Problems& problems);

/// Complains about objects, and parts of the toolbox, whose material says something else than they are: a
/// solid of water, and a body of liquid of a solid material. Such levels can be played, and players have made
/// some. Objects that state an appearance of their own are taken to be meant so.
void complainAboutMatter(PartLibrary const& parts, LevelFile const& level, BuiltLevel const& built,
                         Problems& problems);

/// Complains about one body if so many lie in one place that each frame takes long, see crowdedStart(). The
/// level can be played all the same. The world is that of the level, before its first frame. Returns whether
/// there is a crowd.
bool complainAboutCrowds(LevelFile const& level, World const& world, Problems& problems);

} // namespace trembler
