// Shortens a chain in which a magnet moves a body by one of its alike objects after the other.
#pragma once

#include "insight/why/answer.hpp"

#include <vector>

namespace trembler::insight {

/// Of the pulls of the same magnet, or its pushes, that began in the same frame on objects with the same
/// role, as those of a motor's base magnet on its spokes, only the one from which the latest step follows
/// stays. The effects of the others follow from it. O(steps²).
void joinPulls(std::vector<ChainStep>& chain, SceneFacts const& facts);

} // namespace trembler::insight
