// The columns that Dynamics works with.
#pragma once

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint_anchors.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/column.hpp"

#include <algorithm>

namespace trembler {

struct DynamicsColumns {
    Column<Shape> const& shape;
    Column<Mass> const& mass;
    Column<Fixed> const& fixed;
    Column<Liquid> const& liquid;
    Column<Bullet> const& bullet;
    Column<Friction> const& friction;
    Column<Restitution> const& restitution;
    Column<CollisionGroups> const& groups;
    Column<Damping> const& damping;
    Column<Joint> const& joint;
    Column<JointAnchors> const& anchors;
    Column<DynamicsSettings> const& settings;
    Column<Position> const& position;
    Column<Rotation> const& rotation;
    Column<Velocity> const& velocity;
    Column<AngularVelocity> const& spin;

    /// Changes when any property that a body is made from changes, except its position.
    [[nodiscard]] std::uint64_t bodiesVersion() const {
        return shape.version() + mass.version() + fixed.version() + bullet.version() + friction.version() +
               restitution.version() + groups.version() + damping.version() + liquid.version();
    }
    [[nodiscard]] std::uint64_t jointsVersion() const { return joint.version() + anchors.version(); }
    [[nodiscard]] std::uint64_t motionVersion() const {
        return position.version() + rotation.version() + velocity.version() + spin.version();
    }
    /// Changes when any object gains or loses a place or a velocity.
    [[nodiscard]] std::uint64_t motionStructure() const {
        return position.structureVersion() + rotation.structureVersion() + velocity.structureVersion() +
               spin.structureVersion();
    }
    /// Clamped to the ranges of the description, as programs may write other values.
    [[nodiscard]] DynamicsSettings worldSettings() const {
        DynamicsSettings made = settings.empty() ? DynamicsSettings{} : settings.values().front();
        made.substeps = std::clamp(made.substeps, 0, 64);
        made.velocityIterations = std::clamp(made.velocityIterations, 1, 256);
        made.positionIterations = std::clamp(made.positionIterations, 1, 256);
        made.scale = made.scale >= 1 && made.scale <= 64 ? made.scale : 0;
        return made;
    }
};

/// An object that the simulation must leave out, and why.
struct Refusal {
    ObjectId object;
    std::string why;
};

} // namespace trembler
