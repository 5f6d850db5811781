// The forces of a world's liquids on a body, where the body is and where it is not.
#pragma once

#include "insight/miss/lift/load.hpp"
#include "physics/buoyancy/hulls/exact_hull.hpp"

#include <vector>

namespace trembler::insight::load {

/// A force in a world with its place.
struct ActingForce {
    Vec2 force;        ///< N
    Vec2 at;           ///< m
    ObjectId liquid{}; ///< whose force it is; invalid: gravity's
};

/// The liquids of a world.
class Liquids {
public:
    /// `gravity`: m/s².
    Liquids(World const& world, Vec2 gravity);
    /// The forces on a body that is moved by `by`, m.
    [[nodiscard]] std::vector<ActingForce> on(Body const& body, Vec2 by) const;

private:
    struct One {
        ObjectId id;
        double density = 0; ///< kg/m³
        Vec2 up;
        std::vector<LiquidPiece> pieces;
    };
    Vec2 gravity_; // m/s²
    std::vector<One> liquids_;
};

} // namespace trembler::insight::load
