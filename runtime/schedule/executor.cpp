#include "runtime/schedule/executor.hpp"

#include <tbb/flow_graph.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <deque>
#include <mutex>

namespace trembler {

namespace {

// More threads than cores are allowed on purpose: the determinism tests ask for 32 on two. oneTBB allows the
// whole process what the most modest of its controls says, so there is only one, which grows with the largest
// executor.
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
    arena_->arena.execute([&] {
        tbb::flow::graph graph;
        std::deque<tbb::flow::continue_node<tbb::flow::continue_msg>> nodes;
        std::vector<bool> hasPredecessor(count, false);
        for (std::size_t i = 0; i < count; ++i) {
            nodes.emplace_back(graph, [&f, i](tbb::flow::continue_msg const&) { f(i); });
        }
        for (auto const& [before, after] : edges) {
            tbb::flow::make_edge(nodes[before], nodes[after]);
            hasPredecessor[after] = true;
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (!hasPredecessor[i]) {
                nodes[i].try_put({});
            }
        }
        graph.wait_for_all();
    });
}

} // namespace trembler
