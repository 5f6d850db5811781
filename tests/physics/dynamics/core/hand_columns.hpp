// The columns of Dynamics without a world, to be written by hand.
#pragma once

#include "physics/dynamics/core/columns.hpp"

namespace trembler::test {

struct HandColumns {
    /// A box of 3 kg that can move.
    ObjectId body(std::uint32_t index, Vec2 where = {}, double turned = 0) {
        ObjectId const id{index, 0};
        shape.set(id, Shape{{boxPiece(1, 2)}});
        mass.set(id, Mass{3});
        position.set(id, Position{where});
        rotation.set(id, Rotation{turned});
        velocity.set(id, Velocity{});
        spin.set(id, AngularVelocity{});
        return id;
    }
    [[nodiscard]] DynamicsColumns view() const {
        return {shape,   mass,  fixed,   liquid,   bullet,   friction, restitution, groups,
                damping, joint, anchors, settings, position, rotation, velocity,    spin};
    }

    Column<Shape> shape;
    Column<Mass> mass;
    Column<Fixed> fixed;
    Column<Liquid> liquid;
    Column<Bullet> bullet;
    Column<Friction> friction;
    Column<Restitution> restitution;
    Column<CollisionGroups> groups;
    Column<Damping> damping;
    Column<Joint> joint;
    Column<JointAnchors> anchors;
    Column<DynamicsSettings> settings;
    Column<Position> position;
    Column<Rotation> rotation;
    Column<Velocity> velocity;
    Column<AngularVelocity> spin;
};

} // namespace trembler::test
