// Undo and redo.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace trembler {

/// A sequence of states with a cursor. A change after undo discards the undone states. Not thread-safe.
template <class State>
class History {
public:
    explicit History(State first = {}) : states_{std::move(first)} {}

    [[nodiscard]] State const& now() const { return states_[cursor_]; }
    void change(State next) {
        states_.resize(cursor_ + 1);
        states_.push_back(std::move(next));
        ++cursor_;
    }
    /// Forgets the oldest states beyond `most` that can be undone.
    void forgetBefore(std::size_t most) {
        std::size_t const gone = cursor_ - std::min(cursor_, most);
        states_.erase(states_.begin(), states_.begin() + static_cast<std::ptrdiff_t>(gone));
        cursor_ -= gone;
    }
    [[nodiscard]] bool canUndo() const { return cursor_ > 0; }
    [[nodiscard]] bool canRedo() const { return cursor_ + 1 < states_.size(); }
    bool undo() { return canUndo() && (--cursor_, true); }
    bool redo() { return canRedo() && (++cursor_, true); }

private:
    std::vector<State> states_;
    std::size_t cursor_ = 0;
};

} // namespace trembler
