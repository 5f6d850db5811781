// Runs the project's levels and collects their hashes, for all determinism tests.
#pragma once

#include "puzzle/run/runner.hpp"
#include "tests/support/game_data.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace trembler::determinism {

inline constexpr std::uint64_t frames = 600;
inline constexpr std::uint64_t every = 60;

/// Hashes at every 60th frame of one run.
struct RunHashes {
    std::vector<std::string> state;
    /// Hashes of positions and velocities only: they stay the same when the state hash is extended.
    std::vector<std::string> motion;
    friend bool operator==(RunHashes const&, RunHashes const&) = default;
};
/// The hashes of a level without player input and with each solution, by "hands off" or the solution's name;
/// each run has `length` frames.
[[nodiscard]] std::map<std::string, RunHashes> hashesOf(LevelFile const& level, int threads = 1,
                                                        std::uint64_t length = frames);

} // namespace trembler::determinism
