// How many bodies may lie in one place when a level begins.
#pragma once

#include "runtime/world/registry.hpp"

#include <vector>

namespace trembler {

/// Pairs of pieces that may be near each other: some 6,300 bodies in one place. n bodies inside of each other
/// are n²/2 pairs, whatever they then do to each other, and an engine looks at each of them and keeps a list:
/// this many take about 160 MB and some seconds, 100,000 bodies in one place would take 40 GB.
inline constexpr std::size_t mostNearPairs = 20'000'000;

/// The pieces of bodies are near each other where boxes along the axes around them meet. If there are more
/// than `most` pairs of them: the fault of the body whose piece is near most others, of those up to the one
/// with which there are too many; else nothing. In n log n of all pieces. See ObjectRule.
[[nodiscard]] std::vector<ObjectFault> checkCrowds(Store const& store, std::size_t most);
[[nodiscard]] std::vector<ObjectFault> checkCrowds(Store const& store);

} // namespace trembler
