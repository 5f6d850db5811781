#include "runtime/schedule/executor.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <atomic>
#include <mutex>

namespace trembler {

namespace {

// More threads than cores are allowed on purpose: the determinism tests use 32 on two cores. oneTBB limits
// the whole process to the smallest of its global controls, so there is only one control, which grows with
// the largest executor.
void allow(int threads) {
    static std::mutex mutex;
    static std::unique_ptr<tbb::global_control> allowance;
    std::lock_guard const lock(mutex);
    auto const wanted = static_cast<std::size_t>(threads);
    constexpr auto parallelism = tbb::global_control::max_allowed_parallelism;
    if (tbb::global_control::active_value(parallelism) < wanted) {
        allowance.reset();
        allowance = std::make_unique<tbb::global_control>(parallelism, wanted);
    }
}

} // namespace

struct Executor::Arena {
    explicit Arena(int threads) : arena((allow(threads), threads)) {}
    tbb::task_arena arena;
};

Executor::Executor(int threads)
    : threads_(threads < 1 ? 1 : threads),
      arena_(threads_ > 1 ? std::make_unique<Arena>(threads_) : nullptr) {}

Executor::~Executor() = default;

void Executor::forIndices(std::size_t count, std::function<void(std::size_t)> const& f) {
    if (count <= 1 || !arena_) {
        for (std::size_t i = 0; i < count; ++i) {
            f(i);
        }
        return;
    }
    arena_->arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { f(i); }); });
}

void Executor::runGraph(std::size_t count, std::span<std::pair<std::size_t, std::size_t> const> edges,
                        std::function<void(std::size_t)> const& f) {
    if (count <= 1 || !arena_) {
        for (std::size_t i = 0; i < count; ++i) {
            f(i);
        }
        return;
    }
    // The task that finishes the last predecessor of a node starts it. (A flow graph of oneTBB does the same,
    // but costs more, and its headers cast objects that are destroyed already, which sanitizers report.)
    std::vector<std::vector<std::size_t>> successors(count);
    std::vector<std::atomic<std::size_t>> missing(count);
    for (auto const& [before, after] : edges) {
        successors[before].push_back(after);
        missing[after].fetch_add(1, std::memory_order_relaxed);
    }
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < count; ++i) {
        if (missing[i].load(std::memory_order_relaxed) == 0) {
            roots.push_back(i);
        }
    }
    arena_->arena.execute([&] {
        tbb::task_group group;
        std::function<void(std::size_t)> const start = [&](std::size_t i) {
            group.run([&, i] {
                f(i);
                for (std::size_t const next : successors[i]) {
                    if (missing[next].fetch_sub(1, std::memory_order_acq_rel) == 1) {
                        start(next);
                    }
                }
            });
        };
        for (std::size_t const root : roots) {
            start(root);
        }
        group.wait();
    });
}

} // namespace trembler
