// Independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace trembler::insight {

/// More threads than this are never used.
inline constexpr int mostThreads = 16;

/// How many threads are meant: `wanted`, or one for each processor if it is 0; 1 to mostThreads.
[[nodiscard]] int threadsFor(int wanted);

/// Calls work(i) for every i below `count`, on that many threads, and returns when all have returned. They
/// are begun in ascending order. If any throws, the exception of the lowest i is thrown; the others are
/// completed. With one thread, or one piece, it is the caller's.
void sideBySide(std::size_t count, int threads, std::function<void(std::size_t)> const& work);

} // namespace trembler::insight
