// Gravity between very many masses, detail level "tree".
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/gravity/masses.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/inverse_square/tree.hpp"
#include "runtime/component/dps.hpp"
#include "runtime/placement.hpp"

namespace trembler {

class Store;

/// The law of Real Gravity with far clusters summed as wholes (see inverse_square::Tree): O(n log n) instead
/// of O(n²). GravityLaw's opening angle defines which clusters are far; docs/measurements/accuracy.md has the
/// errors. Action equals reaction only within these errors.
class TreeGravity final : public Dps<TreeGravity, Reads<GravityLaw, Position, Mass>, Derives<GravityForce>> {
public:
    static constexpr ComponentText text{
        .name = "Tree Gravity",
        .effect = "gravity",
        .level = "tree",
        .work =
            "Exports the sum of the attractions of all other masses, with distant clusters as single masses.",
        .rank = -1}; // cheaper than Real Gravity in scenes that it suits
    using Activation = NeedsAll<GravityLaw, Mass, Position>;
    static constexpr int longestPeriod =
        4; // held for longer, the force is no longer an approximation of the same physics
    static constexpr Coverage memory = leftOut("refilled in each update");
    /// The number of masses from which it is three times as fast as Real Gravity; it is faster from about 500
    /// on (bench_many_bodies).
    static constexpr std::size_t worthwhile = 2000;
    static bool suits(Store const& store);
    void update(Access& access);

private:
    inverse_square::Points sources_;
    inverse_square::Points receivers_;
    inverse_square::Tree tree_;
    MassSums sums_;
};

} // namespace trembler
