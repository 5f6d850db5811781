// Only what a scene calls for: what every component of the registry did in a level, and what is left of it
// when the level is at rest.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/world/world.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace trembler {

struct GameData;

/// One component in one play.
struct ComponentUse {
    ComponentInfo const* info = nullptr;
    Activity atEnd = Activity::absent;
    std::uint64_t updates = 0;
    std::uint64_t updatesInLastSecond = 0;
};

/// What a play called for. Counts are the same on every machine: no clock is read.
struct LevelUse {
    std::string level;    ///< as a person would name the file
    std::string title;    ///< as the level states it
    std::string solution; ///< "" for hands off
    std::uint64_t frames = 0;
    std::vector<ComponentUse> components; ///< one per registered component, in the order of World::status()
    std::uint64_t busiestSecond = 0;      ///< updates in it, of all components, of whole seconds from frame 1
    std::uint64_t lastSecond = 0;         ///< updates in it
    /// Whether the world's state was the same, bit for bit, after each frame of the last second.
    bool atRest = false;

    [[nodiscard]] std::size_t constructed() const; ///< components that are there at the end
};

inline constexpr std::uint64_t framesPerSecond = 60;

/// Plays a level, hands off if `solution` is null, on one thread for that many whole seconds, at least one.
/// Throws InputError if the level or the solution does not fit.
[[nodiscard]] LevelUse playForCalls(GameData const& gameData, LevelFile const& level,
                                    Solution const* solution, int seconds);

/// Every level with every recorded solution, in order of path; a level that has none is played hands off.
[[nodiscard]] std::vector<LevelUse> playAllForCalls(GameData const& gameData, int seconds);

} // namespace trembler
