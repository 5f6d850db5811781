// Doing again what was recorded: inputs and changes, each in its frame.
#pragma once

#include "puzzle/session/run.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace trembler {

/// What is fed to a run: that of a recorded solution, or of a run that is repeated.
class Playback {
public:
    /// Nothing.
    Playback() = default;
    /// In any order; those of one frame keep theirs.
    Playback(std::vector<RecordedInput> inputs, std::vector<RecordedChange> changes);

    /// Those of one frame, in the order in which they came.
    [[nodiscard]] std::span<RecordedInput const> inputsOf(std::uint64_t frame) const;
    [[nodiscard]] std::span<RecordedChange const> changesOf(std::uint64_t frame) const;

    /// Makes the changes and feeds the inputs of the run's next frame; call it directly before
    /// LevelRun::step(). An input is left out if it names an object that does not exist in this run, which
    /// may have taken another course. Throws std::invalid_argument, as LevelRun::change() does, for a change
    /// that cannot be made.
    void feed(LevelRun& run) const;

private:
    std::vector<RecordedInput> inputs_;   // ascending by frame
    std::vector<RecordedChange> changes_; // ascending by frame
};

} // namespace trembler
