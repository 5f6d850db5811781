// The parts, actions and effects that a solution needs: found by leaving one of them out and running again.
#pragma once

#include "insight/run/level_runs.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace trembler::insight {

/// One deed of the player in a run: from a grab to the release, a cut, or a removal.
struct Deed {
    std::string what;                ///< "grab crate", "cut lamp, battery plus"
    std::vector<std::size_t> inputs; ///< indices in the solution
};
/// The deeds of a solution in the order in which they begin.
[[nodiscard]] std::vector<Deed> deedsOf(Solution const& solution);

struct Needs {
    bool solves = false;     ///< whether the whole solution solves the level; else the rest is empty
    std::uint64_t frame = 0; ///< in which the whole solution solves it
    /// The solution without its superfluous entries. Nothing more can be left out of it: without any one of
    /// its placements, wires or deeds it does not solve the level in patience() (a 1-minimal subset: Zeller
    /// and Hildebrandt, Simplifying and Isolating Failure-Inducing Input, 2002).
    Solution least;
    /// In which `least` solves the level: an entry that can be left out may have solved it earlier, or
    /// delayed it.
    std::uint64_t leastFrame = 0;
    std::vector<std::string> parts;       ///< of `least`, in order of their names, each once
    std::vector<std::string> deeds;       ///< of `least`
    std::vector<std::string> superfluous; ///< the entries that were left out, in words
    /// Of the effects at work in it that can be left out of the program, those without which `least` does not
    /// solve the level; in order of their names.
    std::vector<std::string> effects;
    std::vector<std::string> idleEffects; ///< the others that were at work
};

/// Whether the effects that a solution needs are found out as well, or Needs::effects and idleEffects stay
/// empty: most of the runs are about them.
enum class EffectsToo : std::uint8_t { yes, no };

/// Runs the solution once for each of its entries and for each effect. A pure function of its arguments, for
/// any number of threads. An entry on which another one depends by name, as a wire to a placed part, can be
/// left out only after that one.
[[nodiscard]] Needs needsOf(LevelRuns const& runs, Solution const& solution, std::uint64_t frames,
                            EffectsToo effects = EffectsToo::yes);

/// For journals. `solution` is the one that was examined.
[[nodiscard]] std::string toText(Needs const& needs);
[[nodiscard]] Needs needsFrom(std::string const& text, Solution const& solution);

} // namespace trembler::insight
