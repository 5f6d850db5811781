// A world of the native engine alone, for tests whose right outcome is a formula.
#pragma once

#include "physics/dynamics/engines/native/native_dynamics.hpp"

#include <deque>
#include <memory>
#include <vector>

namespace trembler::test {

inline constexpr double standardGravity = 9.81;

inline Shape boxShape(double width, double height) {
    Shape shape;
    shape.pieces.push_back(boxPiece(width, height));
    return shape;
}
inline Shape discShape(double radius) {
    Shape shape;
    shape.pieces.push_back(circlePiece(radius));
    return shape;
}

/// What a test states of a body; `mass` 0: from its density.
struct SmallBody {
    Vec2 at;
    Vec2 velocity{};
    double angle = 0;
    double spin = 0;
    double mass = 0;
    double restitution = 0;
    double friction = 0.5;
    bool fixed = false;
    std::int32_t group = 0;
};

class SmallWorld {
public:
    explicit SmallWorld(double gravity = standardGravity) : engine(makeNativeEngine(4)), gravity_(gravity) {
        settings.substeps = 4;
        engine->chooseSubsteps(true);
        engine->noteImpacts(true);
    }

    SlotIndex add(Shape const& shape, SmallBody const& body) {
        Shape const& kept = shapes_.emplace_back(shape);
        BodySpec spec;
        auto const slot = static_cast<SlotIndex>(motions.size());
        spec.object = ObjectId{slot + 1};
        spec.shape = &kept;
        spec.spread = massPropertiesOf(kept);
        spec.mass = body.mass > 0 ? body.mass : massFromDensity(kept, nullptr);
        spec.fixed = body.fixed;
        spec.friction = body.friction;
        spec.restitution = body.restitution;
        spec.groups.group = body.group;
        spec.motion = {body.at, body.angle, body.velocity, body.spin};
        engine->addBody(slot, spec);
        loads.push_back({{0, body.fixed ? 0 : -gravity_ * spec.mass}, 0});
        masses.push_back(spec.mass);
        inertias.push_back(spec.mass * spec.spread.inertiaPerMass);
        motions.push_back(spec.motion);
        return slot;
    }
    SlotIndex floor() { return add(boxShape(60, 0.2), {.at = {0, -0.1}, .fixed = true}); }

    /// A joint at `at`, of springs, ropes and rods from `at` on a to `atB` on b.
    SlotIndex join(JointForm form, SlotIndex a, SlotIndex b, Vec2 at, Vec2 atB, double length = 0,
                   double stiffness = 0) {
        Joint& joint = joints_.emplace_back();
        joint.form = form;
        joint.stiffness = stiffness;
        JointSpec spec;
        spec.joint = &joint;
        spec.a = a;
        spec.b = b;
        spec.anchors.onA = inFrameOf(a, at);
        spec.anchors.onB = inFrameOf(b, atB);
        spec.anchors.referenceAngle = motions[a].angle - (b == noSlot ? 0 : motions[b].angle);
        spec.anchors.length = length;
        engine->addJoint(static_cast<SlotIndex>(joints_.size() - 1), spec);
        return static_cast<SlotIndex>(joints_.size() - 1);
    }
    SlotIndex hinge(SlotIndex a, SlotIndex b, Vec2 at) { return join(JointForm::hinge, a, b, at, at); }

    void step(int frames = 1) {
        for (int i = 0; i < frames; ++i) {
            engine->setLoads(loads);
            engine->step(1.0 / 60, settings);
            for (MovedBody const& moved : engine->moved()) {
                motions[moved.slot] = moved.motion;
            }
            changes.insert(changes.end(), engine->touchChanges().begin(), engine->touchChanges().end());
            engine->touchChanges().clear();
        }
    }

    /// Of places and motion, in J.
    [[nodiscard]] double energy() const {
        double sum = 0;
        for (std::size_t i = 0; i < motions.size(); ++i) {
            Motion const& motion = motions[i];
            if (loads[i].force.y != 0 || lengthSquared(motion.velocity) > 0) {
                sum += masses[i] * (0.5 * lengthSquared(motion.velocity) + gravity_ * motion.centre.y) +
                       0.5 * inertias[i] * motion.spin * motion.spin;
            }
        }
        return sum;
    }

    std::unique_ptr<Engine> engine;
    DynamicsSettings settings;
    std::vector<Motion> motions; ///< by slot
    std::vector<Load> loads;
    std::vector<double> masses;
    std::vector<double> inertias;
    std::vector<TouchChange> changes;

private:
    [[nodiscard]] Vec2 inFrameOf(SlotIndex slot, Vec2 point) const {
        return slot == noSlot ? point : rotated(point - motions[slot].centre, -motions[slot].angle);
    }

    double gravity_;
    std::deque<Shape> shapes_;
    std::deque<Joint> joints_;
};

} // namespace trembler::test
