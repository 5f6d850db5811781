// The success of a run: reported once, and shown until the player closes it.
#pragma once

#include "puzzle/session/session.hpp"

#include <optional>

namespace trembler::ui {

/// Whether a success of this run counts as the player's: not if the level reaches its goals by itself.
[[nodiscard]] bool byPlayer(Session const& session);

/// Follows one run at a time. Not thread-safe.
class Celebration {
public:
    /// To be called after every step of the session. True once in a run, for the step in which the level is
    /// solved by the player: the celebration begins.
    bool noteStep(Session const& session);
    /// The run has ended.
    void reset();
    /// The player has closed it.
    void dismiss() { showing_ = false; }
    /// Lets time pass, s.
    void pass(double seconds) { age_ += showing_ ? seconds : 0; }

    [[nodiscard]] bool showing() const { return showing_; }
    /// The time since it began, s.
    [[nodiscard]] double age() const { return age_; }
    /// When the run was solved, s from its beginning; nothing if it has not been.
    [[nodiscard]] std::optional<double> solvedAt() const { return solvedAt_; }

private:
    std::optional<double> solvedAt_;
    double age_ = 0;
    bool showing_ = false;
};

} // namespace trembler::ui
