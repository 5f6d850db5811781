// The arguments of `trembler solve`.
#pragma once

#include "game/app/options/files/outputs.hpp"
#include "game/app/search/worker_options.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

struct SolveArguments {
    std::vector<std::string> levels; ///< files or folders
    std::vector<std::string> mods;
    OutputTarget json;
    OutputTarget markdown;
    std::optional<std::string> keep; ///< a folder
    bool addToLevel = false;         ///< add what nobody recorded to the level's file
    WorkerArguments work;
    std::optional<std::uint64_t> runs; ///< of each level
    std::uint64_t seed = 1;
    std::uint64_t frames = 1200;
    bool noHands = false;
    bool random = false;
    bool compare = false;
};

} // namespace trembler
