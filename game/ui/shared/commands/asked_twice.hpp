// A question before a command that loses something: the first request asks, the second one confirms.
#pragma once

namespace trembler::ui {

/// Time passes only through pass(). Plain data; any thread.
class AskedTwice {
public:
    /// How long the question stays open, s.
    static constexpr double patience = 4;

    /// Confirms and closes an open question: true. Otherwise opens it: false.
    bool ask() {
        waiting_ = !waiting_;
        waited_ = 0;
        return !waiting_;
    }
    /// Lets time pass, s; an open question closes after `patience`.
    void pass(double seconds) {
        waited_ += seconds;
        waiting_ = waiting_ && waited_ < patience;
    }
    /// Closes the question.
    void forget() { waiting_ = false; }
    /// Whether the question is open.
    [[nodiscard]] bool waiting() const { return waiting_; }

private:
    bool waiting_ = false;
    double waited_ = 0; // s
};

} // namespace trembler::ui
