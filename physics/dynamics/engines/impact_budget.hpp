// Limits the impulses that an engine reports as impacts to what the kinetic energy allows.
#pragma once

#include "physics/dynamics/core/engine.hpp"

#include <span>
#include <vector>

namespace trembler {

/// Not every sudden impulse of a contact is an impact. Parts that touch at the start get their weight, a
/// motor that is blocked by a contact presses on it with its full strength, a new engine takes over a stack,
/// parts overlap or are at odds with a joint: impulses begin or rise, but nothing has collided. An impact
/// takes its impulse from a relative motion. If a motion of energy E is reversed, which is the utmost, the
/// impulse J satisfies J² k / 2 = 4 E, with 1/k the reduced mass of the two bodies at the point of contact.
/// So each impulse of a substep is limited by this condition, where E is the greater one of
/// - the energy of the approach of the two bodies at that point, u² / (2 k), and
/// - the kinetic energy that all bodies that are connected to them, by contacts and joints, lose in the
///   substep, or the energies of approach between them, as bodies in between transmit impacts.
///
/// For each substep: begin(), add() for every rise of an impulse, and, if exceeded(), reset(), link() and
/// lose(), then settle(). If all candidates are known to be of one group of connected bodies: begin(), add(),
/// and settleGroup(). Used by one thread at a time.
class ImpactBudget {
public:
    /// A body before the impact; a fixed one has inverses and velocities of 0.
    struct Body {
        double inverseMass = 0;    ///< 1/kg
        double inverseInertia = 0; ///< 1/(kg m²)
        Vec2 centre;               ///< m, of mass
        Vec2 velocity;             ///< m/s
        double spin = 0;           ///< rad/s

        [[nodiscard]] Vec2 velocityAt(Vec2 point) const {
            return velocity + spin * perpendicular(point - centre);
        }
    };

    void begin() { candidates_.clear(); }
    /// An impulse that may be an impact. `a` and `b` are the bodies of the impact, `slot` that of a movable
    /// one of them.
    void add(Impact const& impact, SlotIndex slot, Body const& a, Body const& b);
    /// Whether an impulse exceeds what the approach of its two bodies allows.
    [[nodiscard]] bool exceeded() const;

    /// Begins to connect `slots` bodies.
    void reset(std::size_t slots);
    /// These two movable bodies touch, or a joint connects them.
    void link(SlotIndex a, SlotIndex b);
    /// The kinetic energy (J) that a movable body has lost in the substep; a gain is ignored.
    void lose(SlotIndex slot, double energy);

    /// Appends the impacts that remain, with limited impulses, in the order of add().
    void settle(std::vector<Impact>& impacts);
    /// The same, with all candidates in one group of connected bodies, which had the kinetic energy `had` (J)
    /// and have lost `lost` of it in the substep.
    void settleGroup(double had, double lost, std::vector<Impact>& impacts);

private:
    struct Candidate {
        Impact impact;
        SlotIndex slot = noSlot;
        double inverse = 0;   // 1/kg: k
        double approach = 0;  // J
        double lightness = 0; // 1/kg, the sum of the inverse masses
    };
    [[nodiscard]] SlotIndex rootOf(SlotIndex slot);
    static void append(Candidate const& one, double energy, std::vector<Impact>& impacts);

    std::vector<Candidate> candidates_;
    std::vector<SlotIndex> parents_; // by slot
    std::vector<double> lost_;       // J, by slot
    std::vector<double> approach_;   // J, by slot
};

/// The kinetic energy, in J, of a movable body.
[[nodiscard]] double kineticEnergy(double mass, double inertia, Vec2 velocity, double spin);

} // namespace trembler
