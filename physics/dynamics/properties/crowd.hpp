// Counts the pieces of bodies that are near each other, and finds crowds that make frames take long.
#pragma once

#include "physics/box_tree.hpp"
#include "runtime/world/store.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

/// The number of pieces of all shapes, those of objects without a body included. Linear.
[[nodiscard]] std::size_t piecesStatedIn(Store const& store);

/// The pieces of all bodies whose shapes are valid.
struct CrowdPieces {
    std::vector<Bounds> boxes;    ///< around each piece, along the axes
    std::vector<ObjectId> bodies; ///< the body of each piece
    std::vector<bool> movable;    ///< whether that body can move
};
[[nodiscard]] CrowdPieces crowdPiecesOf(Store const& store);

/// Bodies that are near so many others that each frame takes long.
struct CrowdedStart {
    std::size_t pairs = 0; ///< of near pieces of two bodies, of which at least one can move
    std::size_t usual = 0; ///< the number of pairs up to which no crowd is reported
    ObjectId body;         ///< the body of the piece that is near the most others
    std::size_t nearest = 0;
};
/// Up to 20,000 pairs (200 bodies in one place), plus 16 for each movable piece, are no crowd: a piece that
/// lies among others, side by side, is near eight of them, and may be in front of some boards. So a level of
/// very many bodies has no crowd, but 250 bodies in one place are one. Pairs of fixed pieces do not count, as
/// no engine compares them. O(n log n) for n pieces; nothing if there is no crowd.
[[nodiscard]] std::optional<CrowdedStart> crowdedStart(Store const& store);
/// "31125 pairs of pieces of bodies lie in one another ...". `name` is that of the body.
[[nodiscard]] std::string inWords(CrowdedStart const& crowd, std::string const& name);

} // namespace trembler
