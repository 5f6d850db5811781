// Repeats recorded inputs and changes, each in its frame.
#pragma once

#include "puzzle/session/run.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace trembler {

/// The inputs and changes to feed to a run: those of a recorded solution, or of a run that is repeated.
class Playback {
public:
    /// Nothing.
    Playback() = default;
    /// The lists may be in any order; entries of one frame keep their order.
    Playback(std::vector<RecordedInput> inputs, std::vector<RecordedChange> changes);

    /// The inputs of one frame, in the order in which they were recorded.
    [[nodiscard]] std::span<RecordedInput const> inputsOf(std::uint64_t frame) const;
    [[nodiscard]] std::span<RecordedChange const> changesOf(std::uint64_t frame) const;

    /// Makes the changes and feeds the inputs of the run's next frame; call it directly before
    /// LevelRun::step(). An input is left out if it names an object that does not exist in this run, which
    /// may differ from the recorded one. Throws std::invalid_argument, as LevelRun::change() does, for a
    /// change that cannot be made.
    void feed(LevelRun& run) const;

private:
    std::vector<RecordedInput> inputs_;   // ascending by frame
    std::vector<RecordedChange> changes_; // ascending by frame
};

} // namespace trembler
