#include "insight/why/runs/side_by_side.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace trembler::insight {

int threadsFor(int wanted) {
    int const all = wanted > 0 ? wanted : static_cast<int>(std::thread::hardware_concurrency());
    return std::clamp(all, 1, mostThreads);
}

void sideBySide(std::size_t count, int threads, std::function<void(std::size_t)> const& work) {
    std::vector<std::exception_ptr> thrown(count);
    std::atomic<std::size_t> next = 0;
    auto const take = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                work(i);
            } catch (...) {
                thrown[i] = std::current_exception();
            }
        }
    };
    std::size_t const helpers = std::min(static_cast<std::size_t>(std::max(threads, 1)), count);
    {
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < helpers; ++i) {
            others.emplace_back(take);
        }
        take();
    }
    for (std::exception_ptr const& one : thrown) {
        if (one) {
            std::rethrow_exception(one);
        }
    }
}

} // namespace trembler::insight
