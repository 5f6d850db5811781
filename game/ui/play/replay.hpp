// Watching a run again: the same inputs at the same frames.
#pragma once

#include "puzzle/session/session.hpp"

#include <vector>

namespace trembler::ui {

/// Feeds recorded inputs, and makes recorded changes, in a run of the same placements. Not thread-safe.
class Replay {
public:
    void load(std::vector<RecordedInput> inputs, std::vector<RecordedChange> changes) {
        inputs_ = std::move(inputs);
        changes_ = std::move(changes);
        loaded_ = true;
    }
    void clear() {
        inputs_.clear();
        changes_.clear();
        loaded_ = false;
    }
    /// A run is being watched, though perhaps one without inputs.
    [[nodiscard]] bool loaded() const { return loaded_; }
    /// Call it directly before each Session::step.
    void beforeStep(Session& session) const;

private:
    std::vector<RecordedInput> inputs_;
    std::vector<RecordedChange> changes_;
    bool loaded_ = false;
};

} // namespace trembler::ui
