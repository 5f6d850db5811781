// The third dimension of a flat world.
#pragma once

namespace trembler {

/// The depth of all objects, in m: an area times this is a volume. Used for masses from densities and for
/// displaced liquids alike.
inline constexpr double worldDepth = 0.1;

} // namespace trembler
