// Measures activation: the work of every registered component while a level is played, and the work that
// remains when the level is at rest.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/world/world.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace trembler {

struct GameData;

/// The work of one component during one play.
struct ComponentUse {
    ComponentInfo const* info = nullptr;
    Activity atEnd = Activity::absent;
    std::uint64_t updates = 0;
    std::uint64_t updatesInLastSecond = 0;
};

/// The components that were active during a play. Counts are the same on every machine: no clock is read.
struct LevelUse {
    std::string level;    ///< path for display
    std::string title;    ///< the title in the level file
    std::string solution; ///< "" for no player input
    std::uint64_t frames = 0;
    std::vector<ComponentUse> components; ///< one per registered component, in the order of World::status()
    /// Most updates in one second, of all components; seconds count from frame 1.
    std::uint64_t busiestSecond = 0;
    std::uint64_t lastSecond = 0; ///< updates in the last second
    /// Whether the world's state was bit for bit the same after each frame of the last second.
    bool atRest = false;

    [[nodiscard]] std::size_t constructed() const; ///< number of components that are constructed at the end
};

inline constexpr std::uint64_t framesPerSecond = 60;

/// Plays a level, without player input if `solution` is null, on one thread for `seconds` whole seconds, at
/// least one. The result points into the registry of `gameData`, which must outlive it. Throws InputError if
/// the level or the solution is invalid.
[[nodiscard]] LevelUse playForCalls(GameData const& gameData, LevelFile const& level,
                                    Solution const* solution, int seconds);

/// Plays every level with every recorded solution, in order of path; a level without solutions is played
/// without player input. The results point into the registry of `gameData`, which must outlive them.
[[nodiscard]] std::vector<LevelUse> playAllForCalls(GameData const& gameData, int seconds);

} // namespace trembler
