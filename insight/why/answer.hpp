// A question about a run, and its answer.
#pragma once

#include "insight/miss/miss_meter.hpp"
#include "insight/why/story/story.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace trembler::insight {

/// Something that was seen to happen, in a run that was not traced.
struct SightedEvent {
    std::uint64_t frame = 0;
    std::vector<std::string> objects; ///< that it was about, by name; not empty
    std::vector<StepKind> kinds;      ///< what it may have been
};

/// The subject of the question; exactly one of the four, or none: the first goal that was not met, or else
/// the solving of the level.
struct Question {
    std::optional<std::string> goal{};     ///< by id
    std::optional<std::uint64_t> event{};  ///< by its number in the trace of the run, as `run --trace` has it
    std::optional<std::string> object{};   ///< why it is as it is ...
    double at = 0;                         ///< ... at this time, in s
    std::optional<SightedEvent> sighted{}; ///< the last such event up to then
};

/// Nothing that can be explained has happened to the object or goal in question.
struct NothingHappened : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// How well a step of a chain is known.
enum class Proof : std::uint8_t {
    traced,    ///< the trace names it, and no run without it was made
    confirmed, ///< without it, what was asked about did not happen
    together,  ///< without it alone it did, but not without it and the others so marked
    refuted,   ///< without it, it happened all the same
};
[[nodiscard]] std::string_view nameOf(Proof proof);

/// One step of the answer.
struct ChainStep {
    Step step;
    Proof proof = Proof::traced;
    /// m, in the world, at its moment: of a contact, where the two touched; else where its first object was.
    Vec2 at;
    /// How often it happened in the chain; earlier times of what repeats are not in it, see foldRepeats().
    std::size_t times = 1;
    std::size_t cycle = 0; ///< steps that were repeated together have the same number, from 1; 0: once
};

struct Answer {
    bool happened = false;
    /// The subject of the question, as a step; if a goal was not met, its id is in `goal`, and the chain is
    /// empty.
    std::string goal;
    /// The chain, earliest first; the last one is what was asked about. `Step::because` are places in it.
    std::vector<ChainStep> chain;
    std::size_t dropped = 0; ///< events that led to it by the trace, and were coincidences
    /// Whether each root of the chain was confirmed by a second run. False for an empty chain.
    bool confirmed = false;
    std::optional<GoalMiss> nearest; ///< of a goal that was not met
    std::size_t runs = 0;            ///< how many runs it took
    bool complete = true;            ///< false: it was cancelled, and has only the results so far
    SceneFacts facts;
    std::uint64_t frames = 0; ///< of the run that was asked about
};

struct AskOptions {
    std::uint64_t frames = 3600; ///< of the run at most
    /// Name gravity's helpers, too: contacts with fixed objects that conduct nothing.
    bool everything = false;
    int threads = 0; ///< that run at the same time, at most 16; 0: one for each processor
    /// Called after each run with the number of runs so far and of those planned; false: no further ones.
    /// From any thread, one at a time.
    std::function<bool(std::size_t done, std::size_t of)> progress;
    /// Asked after every frame, from any thread; true: ends as soon as it can, with the results so far.
    std::function<bool()> stop;
};

/// Answers a question about a run of a level. Runs it once, traced, and then once for each thing that may be
/// a cause, and for sets of them. A pure function of its arguments, as long as `progress` returns true; may
/// be called from any thread; does not depend on the number of threads. Throws std::invalid_argument, naming
/// what there is instead, if there is no such goal, event or object, and if the run is not possible;
/// NothingHappened if there is nothing to explain.
[[nodiscard]] Answer why(LevelRuns const& runs, Solution const& solution, Question const& question,
                         AskOptions const& options = {});

} // namespace trembler::insight
