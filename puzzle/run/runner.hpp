// Runs a level without a window, for `trembler run`, `trembler verify` and the tests.
#pragma once

#include "puzzle/run/run_report.hpp"
#include "puzzle/run/slow_frame.hpp"
#include "puzzle/session/session.hpp"

#include <functional>
#include <iosfwd>

namespace trembler {

struct RunOptions {
    std::uint64_t frames = 600; ///< at most
    bool stopWhenSolved = false;
    std::uint64_t hashEvery = 0;   ///< frames; 0: only the last
    std::ostream* trace = nullptr; ///< receives the trace, as JSON lines
    /// Called after every frame with the number of frames computed, to show progress.
    std::function<void(std::uint64_t)> progress;
    /// For observers, which must change nothing: called before the first frame and after every frame.
    std::function<void(Session&)> enter;
    std::function<void(World const&)> frame;
    /// Called directly before every frame; may change the session as a player can.
    std::function<void(Session&)> before;
    /// Called after each frame of which the timer says that it took long.
    std::function<void(SlowFrame const&)> slow;
    FrameTimer timer{};
};

/// Runs a session from its beginning for a number of frames. The world must trace if options.trace is set.
[[nodiscard]] RunReport run(Session& session, std::string levelName, RunOptions const& options);

} // namespace trembler
