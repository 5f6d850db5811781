// The external forces on bodies: sums of held calls, and the rule by which they wake sleeping bodies.
#pragma once

#include "physics/dynamics/core/bodies.hpp"

#include <cmath>

namespace trembler {

/// The sum of the forces of all effects on one body.
struct LoadSum {
    Load load;
    double gross = 0; ///< N, sum of the magnitudes of all forces
};

/// Sums are added in the order in which calls are drained, which does not depend on threads.
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
    /// That the force on a body varies smoothly with its place; see Load::varies.
    void noteVarying(SlotIndex slot) {
        if (slot < sums_.size()) {
            sums_[slot].load.varies = true;
        }
    }
    /// A resistance (see Drag::add) at `arm` (m) from the centre of mass.
    void addDrag(SlotIndex slot, Vec2 arm, double xx, double xy, double yy, double angular) {
        drags_.resize(sums_.size());
        drags_[slot].add(arm, xx, xy, yy, angular);
    }
    /// Finishes the sums: passes them to the engine, and wakes sleeping bodies whose load has changed since
    /// they fell asleep by more than a five-hundredth of the magnitudes of all its forces. For a body at rest
    /// under Earth's gravity that is 0.02 m/s², which engines with sleeping bodies regard as rest anyway. A
    /// load does not wake a body, either, if it would need a quarter of an hour to accelerate it to a speed
    /// above rest, however weak all other forces on it are.
    void apply(std::span<Body const> bodies, Engine& engine);
    /// Records the load under which bodies have fallen asleep. To be called after each step; `sleeping` is
    /// the setting with which the step was taken.
    void noteSleepers(Engine const& engine, bool sleeping);
    /// The present sums, by slot, without resistance to motion. The list may end before the last slot.
    [[nodiscard]] std::span<LoadSum const> sums() const { return sums_; }
    /// Whether any force has changed, since the last call that returned true, by more than an eighth of the
    /// magnitudes of its parts. O(bodies).
    [[nodiscard]] bool changedMuch();

private:
    [[nodiscard]] static bool differs(LoadSum const& now, Load const& then, Body const& body);

    std::vector<LoadSum> sums_;
    std::vector<LoadSum> known_; // when changedMuch() was last true
    std::vector<Load> loads_;
    std::vector<Drag> drags_;  // empty while there is no resistance
    std::vector<Load> atRest_; // under which a body fell asleep
    std::vector<std::uint8_t> asleep_;
    bool anyAsleep_ = false; // whether some body may be asleep
};

} // namespace trembler
