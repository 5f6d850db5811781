// Options of workers for tests.
#pragma once

#include "insight/spread/workers.hpp"

#include <functional>
#include <utility>

namespace trembler::insight {

inline WorkersOptions onThreads(int threads, Team* team = nullptr, Journal* journal = nullptr,
                                std::function<bool()> stop = {}) {
    WorkersOptions options;
    options.threads = threads;
    options.team = team;
    options.journal = journal;
    options.stop = std::move(stop);
    return options;
}

} // namespace trembler::insight
