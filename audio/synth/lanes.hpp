// Four numbers at a time.
#pragma once

namespace trembler {

/// A vector of four floats with element-wise arithmetic: an extension that g++ and clang++ share.
using Lanes = float __attribute__((vector_size(16)));
inline constexpr int laneCount = 4;

} // namespace trembler
