// Running a level without anybody watching: `trembler run`, `trembler verify` and the tests.
#pragma once

#include "game/session/run_report.hpp"
#include "game/session/session.hpp"

#include <functional>
#include <iosfwd>

namespace trembler {

struct RunOptions {
    std::uint64_t frames = 600; ///< at most
    bool stopWhenSolved = false;
    std::uint64_t hashEvery = 0;   ///< 0: only the last
    std::ostream* trace = nullptr; ///< where the account goes, JSON lines
    /// Called now and then with the frames done, for a sign of progress.
    std::function<void(std::uint64_t)> progress;
};

/// Runs a session from its beginning for a number of frames. The world must trace if options.trace is set.
[[nodiscard]] RunReport run(Session& session, std::string levelName, RunOptions const& options);

} // namespace trembler
