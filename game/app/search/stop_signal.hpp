// Lets Ctrl-C end a long command, which then prints its results so far.
#pragma once

#include <csignal>

namespace trembler {

/// While it lives, the first SIGINT or SIGTERM only sets a flag, and the next one ends the program as usual.
/// One at a time.
class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(StopSignal const&) = delete;
    StopSignal& operator=(StopSignal const&) = delete;

    /// From any thread.
    [[nodiscard]] static bool asked();

private:
    struct ::sigaction interrupt_ {};
    struct ::sigaction terminate_ {};
};

} // namespace trembler
