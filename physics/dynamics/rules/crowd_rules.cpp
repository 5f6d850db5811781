#include "physics/dynamics/rules/crowd_rules.hpp"

#include "physics/dynamics/properties/crowd.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {

std::vector<ObjectFault> checkCrowds(Store const& store, std::size_t most) {
    if (std::size_t const count = piecesStatedIn(store); count * (count / 2 + 1) <= most) {
        return {}; // too few pieces to exceed the limit
    }
    CrowdPieces const pieces = crowdPiecesOf(store);
    BoxTree const tree(pieces.boxes);
    std::size_t sum = 0; // number of pairs, each counted twice
    std::size_t nearest = 0;
    std::size_t crowded = 0; // the piece that is near the most others
    for (std::size_t i = 0; i < pieces.boxes.size() && sum <= 2 * most; ++i) {
        std::size_t const near = std::max<std::size_t>(1, tree.count(pieces.boxes[i])) - 1; // less itself
        sum += near;
        if (near > nearest) {
            nearest = near;
            crowded = i;
        }
    }
    if (sum <= 2 * most) {
        return {};
    }
    return {
        {pieces.bodies[crowded], fmt::format("too many bodies lie in one place: the box around one of its "
                                             "pieces meets those around {} others; expected "
                                             "at most {} pairs of pieces of which the surrounding boxes meet",
                                             nearest, most)}};
}

std::vector<ObjectFault> checkCrowds(Store const& store) {
    return checkCrowds(store, mostNearPairs);
}

} // namespace trembler
