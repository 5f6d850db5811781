// Finds what a question is about, in a first run.
#pragma once

#include "insight/run/placed_names.hpp"
#include "insight/why/answer.hpp"
#include "insight/why/runs/step_places.hpp"

namespace trembler::insight {

/// The target of a question, and how to recognise it in another run.
struct Target {
    std::optional<std::string> goal; ///< its id; "" for the solving of the level
    EventId event;                   ///< in the first run; none if the goal was not met
    std::string component;
    std::string what;
    std::vector<std::string> objects;
    std::size_t times = 1;   ///< occurrences of this event up to it, itself included
    std::uint64_t frame = 0; ///< in which it happened
    Story story;
    StepPlaces places; ///< of the first run
};

/// Runs the solution, traced and measured, and finds the event in it. Fills in the answer's frames, facts,
/// goal, nearest miss, and `complete`: without an event if it was stopped. Throws
/// std::invalid_argument, see why().
[[nodiscard]] Target findTarget(LevelRuns const& runs, Solution const& solution, Question const& question,
                                AskOptions const& options, Answer& answer);

/// How often an event happened in a trace up to a frame. `names` are those of the placed objects in that run.
[[nodiscard]] std::size_t timesIn(std::span<Event const> events, Target const& target, std::uint64_t frame,
                                  PlacedNames const& names = {});

} // namespace trembler::insight
