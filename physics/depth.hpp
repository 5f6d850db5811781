// The third dimension of a flat world.
#pragma once

namespace trembler {

/// How deep everything is, in m: an area times this is a volume. One number in one place, for masses from
/// densities and for displaced liquid alike.
inline constexpr double worldDepth = 0.1;

} // namespace trembler
