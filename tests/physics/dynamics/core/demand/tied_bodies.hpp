// Bodies and joints in the representation of Dynamics, with forces, but without an engine.
#pragma once

#include "physics/dynamics/core/joints.hpp"
#include "physics/dynamics/core/loads.hpp"

#include <vector>

namespace trembler::test {

/// settle() updates the tables with the bodies and joints that have been added or removed.
class TiedBodies {
public:
    /// A body of that mass (kg), rotated by `angle` (rad).
    ObjectId body(Shape shape, Vec2 at, double mass, double angle = 0);
    /// A square of 0.2 m.
    ObjectId body(Vec2 at, double mass) { return body(Shape{{boxPiece(0.2, 0.2)}}, at, mass); }
    ObjectId fixed(Vec2 at);
    ObjectId joint(Joint joint);
    /// A joint between two places in the world, which coincide except for ropes and similar forms.
    ObjectId joint(JointForm form, ObjectId a, ObjectId b, Vec2 at);
    void remove(ObjectId joint);
    /// A force in N at the centre of mass, added to earlier ones.
    void pull(ObjectId body, Vec2 force);
    /// Applies its weight to every movable body, along `acceleration` (m/s²).
    void weigh(Vec2 acceleration);
    void settle();

    [[nodiscard]] DynamicsColumns columns() const;
    [[nodiscard]] BodyTable const& bodies() const { return bodies_; }
    [[nodiscard]] JointTable const& joints() const { return joints_; }
    /// Indexed by slot of the bodies.
    [[nodiscard]] std::vector<LoadSum> loads() const;
    [[nodiscard]] SlotIndex slotOf(ObjectId joint) const;

private:
    /// An engine that is never called: the tests read the tables only.
    class Engine;

    ObjectId create() { return {count_++, 0}; }

    struct Force {
        ObjectId body;
        Vec2 force;
    };

    Column<Shape> shapes_;
    Column<Mass> masses_;
    Column<Fixed> fixed_;
    Column<Liquid> liquids_;
    Column<Bullet> bullets_;
    Column<Friction> frictions_;
    Column<Restitution> restitutions_;
    Column<CollisionGroups> groups_;
    Column<Damping> dampings_;
    Column<Joint> tied_;
    Column<JointAnchors> anchors_;
    Column<DynamicsSettings> settings_;
    Column<Position> positions_;
    Column<Rotation> rotations_;
    Column<Velocity> velocities_;
    Column<AngularVelocity> spins_;
    BodyTable bodies_;
    JointTable joints_;
    std::vector<Force> forces_;
    std::uint32_t count_ = 0;
};

} // namespace trembler::test
