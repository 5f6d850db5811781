// Limits the number of bodies in one place at the start of a level.
#pragma once

#include "runtime/world/registry.hpp"

#include <vector>

namespace trembler {

/// The limit of pairs of pieces that are near each other: some 6,300 bodies in one place. n bodies inside
/// each other have n²/2 pairs, and an engine examines each pair and keeps a list: this many pairs take about
/// 160 MB and some seconds, 100,000 bodies in one place would take 40 GB.
inline constexpr std::size_t mostNearPairs = 20'000'000;

/// Two pieces of bodies are near each other if their bounding boxes meet. If there are more than `most` such
/// pairs, returns the fault of one body: it has the piece that is near the most others, among the pieces
/// counted until the limit is exceeded. O(n log n) for n pieces. See ObjectRule.
[[nodiscard]] std::vector<ObjectFault> checkCrowds(Store const& store, std::size_t most);
[[nodiscard]] std::vector<ObjectFault> checkCrowds(Store const& store);

} // namespace trembler
