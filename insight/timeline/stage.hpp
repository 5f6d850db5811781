// A world that is never stepped: it shows frames of a recording to code that draws and reads worlds.
#pragma once

#include "insight/timeline/recording.hpp"
#include "puzzle/session/run.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace trembler::insight {

/// Its objects have the ids that they had in the recorded run, so what a picture of the run remembers applies
/// to pictures of the stage. Its components do nothing, and World::frame() is always 0: the number of the
/// frame is frame(). Not thread-safe.
class Stage {
public:
    /// Makes a run of the same level with the same placements that has not begun.
    using Build = std::function<std::unique_ptr<LevelRun>()>;

    explicit Stage(Build build);

    /// Shows the frame of the recording that is nearest to `frame`. The recording must be of a run that was
    /// built in the same way. Throws InputError if the run cannot be built again.
    void show(Recording const& recording, std::uint64_t frame);
    /// Makes the run that show() would make first, so that showing the first frame takes no longer than
    /// showing others. Throws as show() does.
    void prepare();
    /// To be called when the recording begins again.
    void forget();

    /// As it was after the shown frame. Valid until show() or forget(); only after show().
    [[nodiscard]] World const& world() const { return run_->world(); }
    /// The number of the shown frame; nothing before show().
    [[nodiscard]] std::optional<std::uint64_t> frame() const { return frame_; }
    /// The goals as they were.
    [[nodiscard]] std::vector<GoalStatus> const& goals() const { return goals_; }
    [[nodiscard]] std::optional<std::uint64_t> solvedFrame() const { return solvedFrame_; }
    /// Counts the worlds that it has used: pointers into an earlier one are no longer valid.
    [[nodiscard]] std::uint64_t builds() const { return builds_; }

private:
    void rebuild();
    void showGoals(Words const& words);
    [[nodiscard]] CallerNames const& callers() const { return *callers_; }

    Build build_;
    std::unique_ptr<LevelRun> run_;
    std::unique_ptr<CallerNames> callers_;
    std::vector<SharedWords> shown_; // of each part; the pointers keep the words alive, so none is confused
    std::optional<std::uint64_t> frame_;
    std::vector<GoalStatus> goals_;
    std::optional<std::uint64_t> solvedFrame_;
    std::uint64_t builds_ = 0;
};

} // namespace trembler::insight
