// Watching a run again: the same inputs at the same frames.
#pragma once

#include "game/session/session.hpp"

#include <vector>

namespace trembler::ui {

/// Feeds recorded inputs into a run of the same placements. Not thread-safe.
class Replay {
public:
    void load(std::vector<RecordedInput> inputs) {
        inputs_ = std::move(inputs);
        loaded_ = true;
    }
    void clear() {
        inputs_.clear();
        loaded_ = false;
    }
    /// A run is being watched, though perhaps one without inputs.
    [[nodiscard]] bool loaded() const { return loaded_; }
    /// Call it directly before each Session::step.
    void beforeStep(Session& session) const;

private:
    std::vector<RecordedInput> inputs_;
    bool loaded_ = false;
};

} // namespace trembler::ui
