// Runs work on threads. No result depends on their number.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace trembler {

/// Rows of work per chunk. A constant, so that chunks, and with them the order of calls, never depend on
/// threads.
inline constexpr std::size_t chunkRows = 1024;

/// A fixed number of threads (oneTBB). Its functions may be called from within its own tasks.
class Executor {
public:
    /// `threads` >= 1, the caller's included.
    explicit Executor(int threads);
    ~Executor();
    Executor(Executor const&) = delete;
    Executor& operator=(Executor const&) = delete;

    [[nodiscard]] int threads() const { return threads_; }
    /// Calls f(i) for i in [0, count), in any order and at the same time; returns when all are done. The
    /// first exception thrown by f is passed on.
    void forIndices(std::size_t count, std::function<void(std::size_t)> const& f);
    /// Calls f(i) for every node such that f(i) starts after f of all its predecessors has ended. `edges` are
    /// pairs (before, after) with before < after. The first exception is passed on; the nodes that depend on
    /// the one that threw it do not run, and other nodes may not run either.
    void runGraph(std::size_t count, std::span<std::pair<std::size_t, std::size_t> const> edges,
                  std::function<void(std::size_t)> const& f);

private:
    struct Arena;
    int threads_;
    std::unique_ptr<Arena> arena_;
};

} // namespace trembler
