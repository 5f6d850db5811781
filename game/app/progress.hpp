// Shows on the terminal how far a command has come.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace trembler {

/// One line on standard error that is overwritten, if standard error is a terminal; otherwise nothing is
/// printed. The first line appears after a second, the next ones every half second. Reads the clock, so
/// nothing computed may depend on it. Not thread-safe.
class Progress {
public:
    Progress();
    ~Progress() { clear(); }
    Progress(Progress const&) = delete;
    Progress& operator=(Progress const&) = delete;

    /// Shows "12 of 100 frames", at the intervals above.
    void frames(std::uint64_t done, std::uint64_t of);
    /// Shows a text at once; for steps that may take long.
    void say(std::string const& words);
    /// Erases the line.
    void clear();

private:
    void show(std::string const& words);

    bool watched_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point next_;
};

} // namespace trembler
