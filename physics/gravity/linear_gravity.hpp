// Gravity as a constant acceleration, detail level "linear".
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/gravity/properties.hpp"
#include "runtime/component/dps.hpp"

namespace trembler {

class Store;

/// F = m g for every object with a mass (6.13.3).
class LinearGravity final : public Dps<LinearGravity, Reads<GravityField, Mass>, Derives<GravityForce>> {
public:
    static constexpr ComponentText text{.name = "Linear Gravity",
                                        .effect = "gravity",
                                        .level = "linear",
                                        .work =
                                            "Exports mass times the world's acceleration for each object.",
                                        .rank = 1};
    using Activation = NeedsAll<GravityField, Mass>;
    static constexpr int longestPeriod = 4; // as of the levels that it may replace
    /// Not for a world that states a law of gravity: without attraction between masses its physics would
    /// differ.
    static bool faithful(Store const& store);
    void update(Access& access);
};

} // namespace trembler
