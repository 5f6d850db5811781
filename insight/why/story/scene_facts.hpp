// Facts about the objects of a run, by name and as they were at the start, for the story of causes.
#pragma once

#include "insight/why/story/main_pulls.hpp"
#include "puzzle/session/run.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace trembler::insight {

struct SceneFacts {
    std::set<std::string> fixed;
    std::set<std::string> conductors;               ///< and sound sensors, by whose touch a current may flow
    std::set<std::string> motors;                   ///< driven by a current
    std::set<std::string> magnets;                  ///< electromagnets as well
    std::set<std::string> lamps;                    ///< see isLamp()
    std::map<std::string, std::size_t> placementOf; ///< objects that were placed, pieces included
    std::map<std::string, Vec2> places;             ///< m, of everything that is somewhere
    /// What sentences call an object whose name says nothing, as "object 2": by its part, "copper contact 2".
    std::map<std::string, std::string> spoken;
    /// Of each object that joints connect with others that can move, the number of their group: what moves
    /// one of them moves them all.
    std::map<std::string, std::size_t> tied;
    /// Of each object that has the same part as others which are welded to the same wheel (a body that a
    /// hinge holds), the number of their role: they take turns, as the spokes of a motor do.
    std::map<std::string, std::size_t> roles;
    MainPulls pulls; ///< of a run that is over
    /// The first frame in which two objects touched in the run, by their names as the trace has them; of a
    /// run that is over.
    std::map<std::vector<std::string>, std::uint64_t> firstTouch;
};

/// To be called before the first frame.
[[nodiscard]] SceneFacts factsOf(LevelRun const& run);

} // namespace trembler::insight
