// Running the project's levels and collecting their hashes, for all determinism tests.
#pragma once

#include "game/core/workshop.hpp"
#include "game/session/runner.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace trembler::determinism {

inline constexpr std::uint64_t frames = 600;
inline constexpr std::uint64_t every = 60;

/// One workshop for the whole test program.
[[nodiscard]] Workshop const& workshop();
/// Hashes at every 60th frame of a level, hands off or with a solution, by "hands off" or the solution's
/// name.
[[nodiscard]] std::map<std::string, std::vector<std::string>> hashesOf(LevelFile const& level,
                                                                       int threads = 1);

} // namespace trembler::determinism
