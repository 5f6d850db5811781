// Converts our joints to Box2D's. Where an angle or a displacement is measured, Box2D's body A is our b (or
// the ground) and its body B our a, so that the value is that of a relative to b; forces scale with length,
// torques with its square.
#include "physics/dynamics/engines/box2d/box2d_engine.hpp"

#include <algorithm>
#include <cfloat>

namespace trembler {
namespace {

float asFloat(double value) {
    return static_cast<float>(std::clamp(value, -1e30, 1e30));
}

} // namespace

b2Joint* Box2dEngine::makeJoint(JointSpec const& spec) {
    Joint const& joint = *spec.joint;
    b2Body* const a = bodies_[spec.a].body;
    b2Body* const b = spec.b == noSlot ? ground_ : bodies_[spec.b].body;
    b2Vec2 const onA = toEngine(spec.anchors.onA);
    b2Vec2 const onB = toEngine(spec.anchors.onB);
    b2Vec2 const axis{asFloat(spec.anchors.axis.x), asFloat(spec.anchors.axis.y)};
    float const reference = asFloat(spec.anchors.referenceAngle);
    float const strength = asFloat(joint.motorStrength * scale_); // as a force
    float const torque = asFloat(joint.motorStrength * scale_ * scale_);
    // Box2D aborts if the lower limit exceeds the upper one, even if the limits are disabled.
    double const limitUnit = joint.form == JointForm::hinge ? 1 : scale_;
    float const lower = joint.limited ? asFloat(joint.lower * limitUnit) : 0;
    float const upper = joint.limited ? asFloat(joint.upper * limitUnit) : 0;
    auto const create = [&](b2JointDef& def, b2Body* first, b2Body* second) {
        def.bodyA = first;
        def.bodyB = second;
        def.collideConnected = joint.collide;
        return world_.CreateJoint(&def);
    };
    switch (joint.form) {
    case JointForm::hinge: {
        b2RevoluteJointDef def;
        def.localAnchorA = onB;
        def.localAnchorB = onA;
        def.referenceAngle = reference;
        def.enableLimit = joint.limited;
        def.lowerAngle = lower;
        def.upperAngle = upper;
        def.enableMotor = joint.motor;
        def.motorSpeed = asFloat(joint.motorSpeed);
        def.maxMotorTorque = torque;
        return create(def, b, a);
    }
    case JointForm::weld: {
        b2WeldJointDef def;
        def.localAnchorA = onB;
        def.localAnchorB = onA;
        def.referenceAngle = reference;
        return create(def, b, a);
    }
    case JointForm::slider: {
        b2PrismaticJointDef def;
        def.localAnchorA = onB;
        def.localAnchorB = onA;
        def.localAxisA = axis;
        def.referenceAngle = reference;
        def.enableLimit = joint.limited;
        def.lowerTranslation = lower;
        def.upperTranslation = upper;
        def.enableMotor = joint.motor;
        def.motorSpeed = asFloat(joint.motorSpeed * scale_);
        def.maxMotorForce = strength;
        return create(def, b, a);
    }
    case JointForm::wheel: {
        b2WheelJointDef def;
        def.localAnchorA = onB;
        def.localAnchorB = onA;
        def.localAxisA = axis;
        def.enableLimit = joint.limited;
        def.lowerTranslation = lower;
        def.upperTranslation = upper;
        def.enableMotor = joint.motor;
        def.motorSpeed = asFloat(joint.motorSpeed);
        def.maxMotorTorque = torque;
        def.stiffness = asFloat(joint.stiffness);
        def.damping = asFloat(joint.dampingRate);
        return create(def, b, a);
    }
    case JointForm::distance:
    case JointForm::rope:
    case JointForm::spring: {
        b2DistanceJointDef def;
        def.localAnchorA = onB;
        def.localAnchorB = onA;
        def.length = asFloat(spec.anchors.length * scale_);
        def.minLength = joint.form == JointForm::distance ? def.length : 0.0F;
        def.maxLength = joint.form == JointForm::spring ? FLT_MAX : def.length;
        if (joint.form == JointForm::spring) {
            def.stiffness = asFloat(joint.stiffness);
            def.damping = asFloat(joint.dampingRate);
        }
        return create(def, b, a);
    }
    case JointForm::pulley: {
        b2PulleyJointDef def;
        def.groundAnchorA = toEngine(joint.groundA);
        def.groundAnchorB = toEngine(joint.groundB);
        def.localAnchorA = onA;
        def.localAnchorB = onB;
        def.lengthA = asFloat(spec.anchors.length * scale_);
        def.lengthB = asFloat(spec.anchors.lengthB * scale_);
        def.ratio = asFloat(joint.ratio);
        return create(def, a, b);
    }
    case JointForm::gear: {
        b2GearJointDef def;
        def.joint1 = joints_[spec.gearA].joint;
        def.joint2 = joints_[spec.gearB].joint;
        bool const aSlides = def.joint1->GetType() == e_prismaticJoint;
        bool const bSlides = def.joint2->GetType() == e_prismaticJoint;
        double const units = (aSlides ? scale_ : 1) / (bSlides ? scale_ : 1);
        def.ratio = asFloat(joint.ratio * units);
        return create(def, def.joint1->GetBodyB(), def.joint2->GetBodyB());
    }
    }
    return nullptr;
}

void Box2dEngine::addJoint(SlotIndex slot, JointSpec const& spec) {
    if (joints_.size() <= slot) {
        joints_.resize(slot + std::size_t{1});
    }
    tiesStale_ = true;
    Joint const& joint = *spec.joint;
    bool const motor =
        joint.form == JointForm::hinge || joint.form == JointForm::slider || joint.form == JointForm::wheel;
    joints_[slot] = {.joint = makeJoint(spec),
                     .a = spec.a,
                     .b = joint.form == JointForm::gear ? slotOf(joints_[spec.gearB].joint->GetBodyB())
                                                        : spec.b,
                     .restless = motor && joint.motor && joint.motorSpeed != 0 && joint.motorStrength > 0,
                     .force = {}};
    JointEntry const& entry = joints_[slot];
    for (SlotIndex const body : {entry.a, entry.b}) {
        if (body != noSlot) {
            keepAwake(body, entry.restless ? 1 : 0);
            wake(body);
        }
    }
}

void Box2dEngine::removeJoint(SlotIndex slot) {
    JointEntry const entry = joints_[slot];
    world_.DestroyJoint(entry.joint);
    tiesStale_ = true;
    joints_[slot] = {};
    for (SlotIndex const body : {entry.a, entry.b}) {
        if (body != noSlot) {
            keepAwake(body, entry.restless ? -1 : 0);
            wake(body);
        }
    }
}

} // namespace trembler
