// The forces that act on bodies from outside: sums of held calls, and the rule by which they wake sleepers.
#pragma once

#include "physics/dynamics/core/bodies.hpp"

#include <cmath>

namespace trembler {

/// The sum of the forces on one body, whichever effects they come from.
struct LoadSum {
    Load load;
    double gross = 0; ///< N, of all forces, whichever way they point
};

/// Sums are made in the order in which calls are drained, which depends on no thread.
class LoadTable {
public:
    /// Starts new sums.
    void clear(std::size_t slots);
    void add(SlotIndex slot, Vec2 force, double torque) {
        LoadSum& sum = sums_[slot];
        sum.load.force += force;
        sum.load.torque += torque;
        sum.gross += std::abs(force.x) + std::abs(force.y);
    }
    /// A resistance (see Drag::add) at `arm` (m) from the centre of mass.
    void addDrag(SlotIndex slot, Vec2 arm, double xx, double xy, double yy, double angular) {
        drags_.resize(sums_.size());
        drags_[slot].add(arm, xx, xy, yy, angular);
    }
    /// Ends the sums: hands them to the engine, and wakes sleepers whose load has changed since they fell
    /// asleep by more than a five-hundredth of all the forces that it is made of. For a body at rest under
    /// Earth's gravity that is 0.02 m/s², which an engine that puts bodies to sleep takes for rest anyway.
    /// Nor does a load wake a body if it would need a quarter of an hour to accelerate it to the speed that
    /// such an engine takes for rest, however weak all other forces on it are.
    void apply(std::span<Body const> bodies, Engine& engine);
    /// Remembers the load under which bodies have fallen asleep. After each step.
    void noteSleepers(Engine const& engine);
    /// The present sums, by slot; without resistance to motion. It may end before the last slot.
    [[nodiscard]] std::span<LoadSum const> sums() const { return sums_; }
    /// Whether any force is another one, by more than an eighth of all the forces that it is made of, than
    /// when this was last true: O(bodies).
    [[nodiscard]] bool changedMuch();

private:
    [[nodiscard]] static bool differs(LoadSum const& now, Load const& then, Body const& body);

    std::vector<LoadSum> sums_;
    std::vector<LoadSum> known_; // when changedMuch() was last true
    std::vector<Load> loads_;
    std::vector<Drag> drags_;  // empty while nothing resists any motion
    std::vector<Load> atRest_; // under which a body fell asleep
    std::vector<std::uint8_t> asleep_;
};

} // namespace trembler
