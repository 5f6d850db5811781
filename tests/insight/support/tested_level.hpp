// Levels of the game for tests that run them many times.
#pragma once

#include "insight/trial/level_under_test.hpp"
#include "tests/support/game_data.hpp"

#include <string>

namespace trembler::insight {

inline std::filesystem::path testedFile(std::string const& name) {
    return std::filesystem::path(TREMBLER_SOURCE_DIR) / "levels" / name;
}

/// A gap in a circuit, and a toolbox with a steel bar, a wooden bar and a spanner.
inline LevelUnderTest const& firstContact() {
    static LevelUnderTest const level(gameData(), testedFile("first/1-first-contact.json"));
    return level;
}

/// A solution that places one part.
inline Solution placing(std::string const& part, Vec2 at, double angle = 0) {
    Solution solution;
    Placement placement;
    placement.part = part;
    placement.at = at;
    placement.angle = angle;
    solution.placements.push_back(placement);
    return solution;
}

} // namespace trembler::insight
