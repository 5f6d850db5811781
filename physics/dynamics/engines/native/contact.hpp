// Bodies and contacts as the native engine keeps them.
#pragma once

#include "physics/dynamics/core/drag.hpp"
#include "physics/dynamics/engines/native/convex.hpp"

namespace trembler::native {

/// How contacts bear a body in a substep.
enum class Borne : std::uint8_t { not_at_all, sliding, held };

/// What a substep reads and changes of a body. A fixed body has inverse masses of 0.
struct alignas(64) MovingState {
    Vec2 velocity;             ///< m/s
    double spin = 0;           ///< rad/s
    double inverseMass = 0;    ///< 1/kg
    double inverseInertia = 0; ///< 1/(kg m²)
    Vec2 moved;                ///< m, since the contacts were found
    double turned = 0;         ///< rad, likewise
    double cosine = 1;         ///< of `turned`
    double sine = 0;
    Vec2 accelerated;       ///< m/s, by loads in this substep
    double accelerates = 0; ///< rad/s, likewise
    Borne borne = Borne::not_at_all;
    Vec2 slidesAlong;      ///< unit, if it slides in one direction
    Vec2 velocityBefore;   ///< m/s, at the substep's beginning
    double spinBefore = 0; ///< rad/s

    [[nodiscard]] Vec2 turn(Vec2 v) const { return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y}; }
};

/// What changes rarely.
struct BodyEntry {
    ObjectId object; ///< invalid: the slot is free
    bool fixed = false;
    double mass = 0;    ///< kg; of a movable body
    double inertia = 0; ///< kg m²
    double friction = 0;
    double restitution = 0;
    CollisionGroups groups;
    Damping damping;
    Load load;
    Load loadBefore;     ///< that of the last step
    int steps = 0;       ///< up to 2, of its life
    double lastStep = 0; ///< s, the last step if the body was awake, else 0
    Vec2 centre;         ///< m
    double angle = 0;    ///< rad
    double thin = 0;     ///< m, radius of the largest disc in it, about
    double extent = 0;   ///< m, of its farthest point from the centre of mass
    std::vector<Convex> pieces;
    bool placed = false; ///< since its contacts were found
    int joints = 0;
    int restlessJoints = 0; ///< motors that must not fall asleep
    double idle = 0;        ///< s, for which it has been slow
    int troubles = 0;       ///< steps in which its island's joints could not hold; of the island's first body
    double smoothStep = 0;  ///< s, of its island's last smooth motion; of the island's first body
    std::uint32_t nap = 0;  ///< names the group with which it fell asleep
};

/// A pair of pieces that are near. It lasts while they are, so that it keeps its forces.
struct Contact {
    std::uint64_t key = 0;
    SlotIndex a = noSlot; ///< below b
    SlotIndex b = noSlot;
    Meeting meeting;
    double within =
        -1; ///< m, distance up to which the meeting has its points; negative: the bodies have moved
    bool used = false;              ///< has points, and is no seam
    bool pressed = false;           ///< at some time within this step
    bool touches = false;           ///< as reported
    double pressure = 0;            ///< N, of all points, in the last substep: what is more is an impact
    std::array<double, 2> force{};  ///< N, along the normal
    std::array<double, 2> drag{};   ///< N, across it
    std::array<double, 2> steady{}; ///< N, along the normal, mean of the last frames
};

/// A point of a contact while its island is solved: what every substep reads.
struct PointRow {
    double normalA = 0; ///< m, arm of a normal impulse about the centre of mass of a
    double normalB = 0;
    double acrossA = 0; ///< m, likewise of an impulse across the normal
    double acrossB = 0;
    double now = 0;           ///< m, gap at the beginning of this substep
    double normalInverse = 0; ///< 1/kg
    double tangentMass = 0;   ///< kg
    double normal = 0;        ///< N s, impulse of this substep
    double steady = 0;        ///< N s, at which its spring is not compressed
    double tangent = 0;       ///< N s
};

/// The rest of a contact's row, which is read once in a substep or less.
struct RowDetail {
    Contact* contact = nullptr;
    double restitution = 0;
    double struck = 0;          ///< N s, of impacts in this substep
    std::array<Vec2, 2> armA{}; ///< m, turns with a
    std::array<Vec2, 2> armB{};
    std::array<Vec2, 2> reachA{}; ///< m, to the point of contact, when the contacts were found
    std::array<Vec2, 2> reachB{};
    std::array<double, 2> gap{}; ///< m, when the contacts were found
};

struct ContactRow {
    SlotIndex a = noSlot;
    SlotIndex b = noSlot;
    int count = 0;
    bool awaits = false;  ///< will bounce within this substep: must not be slowed down before
    bool bounces = false; ///< has a restitution
    Vec2 normal;
    double friction = 0;
    double coupling = 0; ///< 1/kg: of the points' normal impulses
    std::array<PointRow, 2> points;
    RowDetail* detail = nullptr;
};

} // namespace trembler::native
