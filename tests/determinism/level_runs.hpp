// Runs the project's levels and collects their hashes, for all determinism tests.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/run/runner.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace trembler::determinism {

inline constexpr std::uint64_t frames = 600;
inline constexpr std::uint64_t every = 60;

/// One GameData for the whole test program.
[[nodiscard]] GameData const& gameData();
/// Hashes at every 60th frame of one run.
struct RunHashes {
    std::vector<std::string> state;
    /// Of where bodies are and how they move, and of nothing else: what the state hash covers may grow, the
    /// motion stays.
    std::vector<std::string> motion;
    friend bool operator==(RunHashes const&, RunHashes const&) = default;
};
/// The hashes of a level, hands off or with a solution, by "hands off" or the solution's name; each run has
/// `length` frames.
[[nodiscard]] std::map<std::string, RunHashes> hashesOf(LevelFile const& level, int threads = 1,
                                                        std::uint64_t length = frames);

} // namespace trembler::determinism
