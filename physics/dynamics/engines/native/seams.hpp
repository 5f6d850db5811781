// Pieces that lie flush are one surface: a body that slides or rolls over them must not feel the seams.
#pragma once

#include "physics/dynamics/engines/native/contact.hpp"

#include <span>
#include <vector>

namespace trembler::native {

/// Steps of a surface lower than this (m) are none.
inline constexpr double seamStep = 5e-4;

/// Clears `used` of contacts that are seams. A contact of a body with a piece is one if another piece, which
/// the body meets as well, hides it: the side that it meets is covered on both sides of the point, or the
/// direction of a corner's contact points into the other piece. So nothing is lost: the body is held by the
/// other piece.
void leaveOutSeams(std::span<Contact* const> contacts, std::span<BodyEntry const> bodies,
                   std::vector<Pose> const& poses);

} // namespace trembler::native
