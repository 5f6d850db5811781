// One run of a level with some placements and inputs, in a few milliseconds.
#pragma once

#include "insight/trial/level_under_test.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace trembler::insight {

struct TrialOptions {
    std::uint64_t frames = 1800; ///< at most
    /// Other components than the game data's: without an effect. Must outlive the trial.
    Registry const* registry = nullptr;
    /// Whether the parts must fit where a player puts them, without overlapping anything.
    bool mustFit = true;
    bool measureMiss = false; ///< whether to measure how nearly it was solved, which takes some time
};

/// Two places between which something was missing at the nearest miss of a goal: the ends of a gap in a
/// circuit, or the place of an object and the one where it should have been; m, in the world.
struct Lacking {
    Vec2 from;
    Vec2 to;
    bool isGap = false;

    friend bool operator==(Lacking const&, Lacking const&) = default;
};

struct TrialResult {
    bool fits = true; ///< false: a player could not place the parts so; nothing was run
    bool solved = false;
    std::uint64_t frame = 0; ///< in which it was solved, or the last one
    /// How far the run was from meeting the goals, 0 to 1, at its nearest; 0 if it was solved. 1 unless it
    /// was measured.
    double miss = 1;
    /// Of the goals that were not met, if it was measured; at most 8.
    std::vector<Lacking> lacking{};

    friend bool operator==(TrialResult const&, TrialResult const&) = default;
};

/// A pure function of its arguments, for any number of threads. The run ends when the level is solved, after
/// `frames`, or when the world is at rest, so that nothing but the time for which goals must hold can
/// change any more. Throws InputError if no world can be built.
[[nodiscard]] TrialResult tryOut(LevelUnderTest const& level, Solution const& solution,
                                 TrialOptions const& options);

/// Why a player could not place the parts so, in words; nothing if that is possible.
[[nodiscard]] std::optional<std::string> whyNotPlaced(LevelUnderTest const& level, Solution const& solution);

/// One line of text from which the same result is made again.
[[nodiscard]] std::string toText(TrialResult const& result);
[[nodiscard]] TrialResult trialFrom(std::string const& text);

/// For how long a recorded solution is run, in frames: as it states, else as `trembler verify` does.
[[nodiscard]] std::uint64_t framesOf(Solution const& solution);
/// For how long a changed run of a solution may last that solves the level in that frame: twice as long, and
/// 5 s more, but at most `most` frames.
[[nodiscard]] std::uint64_t patience(std::uint64_t solvedFrame, std::uint64_t most);

} // namespace trembler::insight
