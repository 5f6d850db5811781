// How far a command is, for whoever watches.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace trembler {

/// One line on standard error that is written over, if standard error is a terminal; else nothing. The first
/// appears after a second, the next each half a second. Reads the clock, and so belongs to nothing that is
/// computed. One thread at a time.
class Progress {
public:
    Progress();
    ~Progress() { clear(); }
    Progress(Progress const&) = delete;
    Progress& operator=(Progress const&) = delete;

    [[nodiscard]] bool watched() const { return watched_; }
    /// "12 of 100 frames", now and then.
    void frames(std::uint64_t done, std::uint64_t of);
    /// Some words, at once; for steps that may take long.
    void say(std::string const& words);
    /// Takes the line away.
    void clear();

private:
    void show(std::string const& words);

    bool watched_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point next_;
};

} // namespace trembler
