// A run's success: told once, and celebrated until the player goes on.
#pragma once

#include "puzzle/session/session.hpp"

#include <optional>

namespace trembler::ui {

/// Of one run at a time. Not thread-safe.
class Celebration {
public:
    /// After every step of the session. True for the first one of this run in which it is solved: it begins.
    bool noteStep(Session const& session);
    /// Another run, or none.
    void reset();
    /// The player has seen it.
    void dismiss() { showing_ = false; }
    /// Lets time pass, s.
    void pass(double seconds) { age_ += showing_ ? seconds : 0; }

    [[nodiscard]] bool showing() const { return showing_; }
    /// How long it has been going on, s.
    [[nodiscard]] double age() const { return age_; }
    /// When the run was solved, s from its beginning; nothing if it has not been.
    [[nodiscard]] std::optional<double> solvedAt() const { return solvedAt_; }

private:
    std::optional<double> solvedAt_;
    double age_ = 0;
    bool showing_ = false;
};

} // namespace trembler::ui
