// The report of `trembler run`, in words and as JSON.
#pragma once

#include "runtime/world/world.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

/// One goal at the end of a run.
struct GoalReport {
    std::string id;
    std::string text;
    bool met = false;
    std::optional<std::uint64_t> frame; ///< in which it was met
};

/// The state hash after a frame.
struct HashAt {
    std::uint64_t frame = 0;
    std::uint64_t hash = 0;
};

struct RunReport {
    std::string level;
    std::uint64_t frames = 0;
    double wallSeconds = 0; ///< for people to read; does not affect the world
    int threads = 1;
    std::uint32_t parts = 1; ///< the greatest number of parts of a frame
    bool solved = false;
    std::optional<std::uint64_t> solvedFrame;
    std::vector<GoalReport> goals;
    std::uint64_t stateHash = 0;
    std::vector<HashAt> hashes;
    std::vector<ComponentStatus> effects;
    std::vector<std::string> warnings; ///< see warningsOf()

    [[nodiscard]] double simulatedSeconds() const { return static_cast<double>(frames) * frameDuration; }
};

/// 16 hex digits.
[[nodiscard]] std::string hashText(std::uint64_t hash);
/// The object that --json prints; other programs rely on its keys.
[[nodiscard]] nlohmann::ordered_json toJson(RunReport const& report);
/// A summary for people, a few lines.
[[nodiscard]] std::string toWords(RunReport const& report);

} // namespace trembler
