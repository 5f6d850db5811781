// For what loses something: the first time it only asks.
#pragma once

namespace trembler::ui {

/// Never looks at a clock itself. Plain data; any thread.
class AskedTwice {
public:
    /// How long the question stands, s.
    static constexpr double patience = 4;

    /// True if it was asked for before and the question still stands; otherwise the question stands from now.
    bool ask() {
        waiting_ = !waiting_;
        waited_ = 0;
        return !waiting_;
    }
    /// Lets time pass, s; the question falls when it has waited for too long.
    void pass(double seconds) {
        waited_ += seconds;
        waiting_ = waiting_ && waited_ < patience;
    }
    /// The question falls.
    void forget() { waiting_ = false; }
    [[nodiscard]] bool waiting() const { return waiting_; }

private:
    bool waiting_ = false;
    double waited_ = 0; // s
};

} // namespace trembler::ui
