// Converts our joints to ODE's. ODE takes a joint's anchors, axis and zero position from the poses of its
// bodies at the time it is attached: so the bodies are temporarily moved to the joint's own zero.
#ifdef TREMBLER_HAS_ODE
#include "physics/dynamics/engines/ode/ode_engine.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

constexpr double shortestRope = 1e-9; // m: a shorter distance has no direction

void putAt(dBodyID body, Vec2 centre, double angle) {
    if (body != nullptr) {
        dBodySetPosition(body, centre.x, centre.y, 0);
        dQuaternion const turned{std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
        dBodySetQuaternion(body, turned);
    }
}

// Whether ODE has no joint of this form.
bool asRows(JointForm form) {
    return form == JointForm::gear || form == JointForm::pulley || form == JointForm::wheel;
}

} // namespace

void OdeEngine::makeJoint(SlotIndex slot, JointSpec const& spec) {
    if (joined_.size() <= slot) {
        joined_.resize(slot + std::size_t{1});
    }
    joined_[slot] = std::make_unique<Joined>();
    Joined& joined = *joined_[slot];
    joined.joint = *spec.joint;
    joined.anchors = spec.anchors;
    joined.a = spec.a;
    joined.b = spec.b;
    joined.feedback = std::make_unique<dJointFeedback>();
    if (joined.joint.form == JointForm::gear) {
        joined.rows.emplace(spec, &*joined_[spec.gearA]->rows, &*joined_[spec.gearB]->rows);
    } else {
        joined.rows.emplace(spec); // a gear may couple any joint
    }
    if (!joined.joint.collide && spec.b != noSlot) {
        ++apart_[std::minmax(spec.a, spec.b)];
    }
    attach(joined);
}

void OdeEngine::dropJoint(SlotIndex slot) {
    Joined const& joined = *joined_[slot];
    if (!joined.joint.collide && joined.b != noSlot) {
        auto const at = apart_.find(std::minmax(joined.a, joined.b));
        if (--at->second == 0) {
            apart_.erase(at);
        }
    }
    joined_[slot].reset();
}

void OdeEngine::attach(Joined& joined) {
    joined.main.reset();
    joined.drive.reset();
    joined.flipped = idOf(joined.a) == nullptr;
    if (asRows(joined.joint.form) || (joined.flipped && idOf(joined.b) == nullptr)) {
        return;
    }
    dBodyID const a = idOf(joined.a);
    dBodyID const b = idOf(joined.b);
    dBodyID const first = joined.flipped ? b : a;
    dBodyID const second = joined.flipped ? a : b;
    // Move to the joint's zero: the movable body relative to the fixed one, or a relative to b.
    Motion const atA = motionOrOrigin(joined.a);
    Motion const atB = motionOrOrigin(joined.b);
    Motion zeroA = atA;
    Motion zeroB = atB;
    if (joined.flipped) {
        zeroB.angle = atA.angle - joined.anchors.referenceAngle;
        zeroB.centre =
            atA.centre + rotated(joined.anchors.onA, atA.angle) - rotated(joined.anchors.onB, zeroB.angle);
    } else {
        zeroA.angle = atB.angle + joined.anchors.referenceAngle;
        zeroA.centre =
            atB.centre + rotated(joined.anchors.onB, atB.angle) - rotated(joined.anchors.onA, zeroA.angle);
    }
    putAt(a, zeroA.centre, zeroA.angle);
    putAt(b, zeroB.centre, zeroB.angle);
    Vec2 const pin = zeroB.centre + rotated(joined.anchors.onB, zeroB.angle);
    Vec2 const axis = rotated(joined.anchors.axis, zeroB.angle);
    dWorldID const world = world_.get();
    switch (joined.joint.form) {
    case JointForm::hinge:
        joined.main.reset(dJointCreateHinge(world, nullptr));
        dJointAttach(joined.main.get(), first, second);
        dJointSetHingeAnchor(joined.main.get(), pin.x, pin.y, 0);
        dJointSetHingeAxis(joined.main.get(), 0, 0, 1);
        attachHinge(joined);
        break;
    case JointForm::weld:
        joined.main.reset(dJointCreateFixed(world, nullptr));
        dJointAttach(joined.main.get(), first, second);
        dJointSetFixed(joined.main.get());
        break;
    case JointForm::slider:
        joined.main.reset(dJointCreateSlider(world, nullptr));
        dJointAttach(joined.main.get(), first, second);
        // Relative to the other body the same axis has the opposite direction.
        dJointSetSliderAxis(joined.main.get(), joined.flipped ? -axis.x : axis.x,
                            joined.flipped ? -axis.y : axis.y, 0);
        if (joined.joint.limited) {
            dJointSetSliderParam(joined.main.get(), dParamLoStop, joined.joint.lower);
            dJointSetSliderParam(joined.main.get(), dParamHiStop, joined.joint.upper);
        }
        if (joined.joint.motor) {
            dJointSetSliderParam(joined.main.get(), dParamVel, joined.joint.motorSpeed);
            dJointSetSliderParam(joined.main.get(), dParamFMax, joined.joint.motorStrength);
        }
        break;
    case JointForm::distance:
    case JointForm::spring: {
        bool const soft = joined.joint.form == JointForm::spring;
        if (soft && joined.joint.stiffness <= 0 && joined.joint.dampingRate <= 0) {
            break;
        }
        joined.main.reset(dJointCreateDBall(world, nullptr));
        dJointAttach(joined.main.get(), first, second);
        Vec2 const endA = zeroA.centre + rotated(joined.anchors.onA, zeroA.angle);
        Vec2 const ends[2] = {joined.flipped ? pin : endA, joined.flipped ? endA : pin};
        dJointSetDBallAnchor1(joined.main.get(), ends[0].x, ends[0].y, 0);
        dJointSetDBallAnchor2(joined.main.get(), ends[1].x, ends[1].y, 0);
        dJointSetDBallDistance(joined.main.get(), joined.anchors.length);
        break;
    }
    case JointForm::rope: // a contact while it is taut: see pullTaut()
    case JointForm::pulley:
    case JointForm::gear:
    case JointForm::wheel:
        break;
    }
    putAt(a, atA.centre, atA.angle);
    putAt(b, atB.centre, atB.angle);
    if (joined.main) {
        dJointSetFeedback(joined.main.get(), joined.feedback.get());
    }
}

// ODE's hinges do not count whole turns; so an angular motor receives the angle.
void OdeEngine::attachHinge(Joined& joined) {
    Joint const& joint = joined.joint;
    if (!joint.limited && !joint.motor) {
        return;
    }
    joined.drive.reset(dJointCreateAMotor(world_.get(), nullptr));
    dJointID const drive = joined.drive.get();
    dJointAttach(drive, idOf(joined.flipped ? joined.b : joined.a),
                 idOf(joined.flipped ? joined.a : joined.b));
    dJointSetAMotorMode(drive, dAMotorUser);
    dJointSetAMotorNumAxes(drive, 1);
    dJointSetAMotorAxis(drive, 0, 0, 0, 0, 1);
    double const sign = joined.flipped ? -1 : 1;
    if (joint.limited) {
        dJointSetAMotorParam(drive, dParamLoStop, joined.flipped ? -joint.upper : joint.lower);
        dJointSetAMotorParam(drive, dParamHiStop, joined.flipped ? -joint.lower : joint.upper);
    }
    if (joint.motor) {
        dJointSetAMotorParam(drive, dParamVel, sign * joint.motorSpeed);
        dJointSetAMotorParam(drive, dParamFMax, joint.motorStrength);
    }
}

void OdeEngine::prepareJoints(double h) {
    for (auto const& joined : joined_) {
        if (!joined) {
            continue;
        }
        *joined->feedback = {};
        if (joined->drive) {
            double const angle = motionOrOrigin(joined->a).angle - motionOrOrigin(joined->b).angle -
                                 joined->anchors.referenceAngle;
            dJointSetAMotorAngle(joined->drive.get(), 0, joined->flipped ? -angle : angle);
        }
        if (joined->joint.form == JointForm::spring && joined->main) {
            double const hk = h * joined->joint.stiffness;
            double const sum = hk + joined->joint.dampingRate;
            dJointSetDBallParam(joined->main.get(), dParamERP, hk / sum);
            dJointSetDBallParam(joined->main.get(), dParamCFM, 1 / sum);
        }
        if (joined->joint.form == JointForm::rope) {
            pullTaut(*joined);
        }
    }
}

void OdeEngine::pullTaut(Joined& joined) {
    if ((!moves(joined.a) || !isAwake(joined.a)) && (!moves(joined.b) || !isAwake(joined.b))) {
        return;
    }
    Motion const atA = motionOrOrigin(joined.a);
    Motion const atB = motionOrOrigin(joined.b);
    Vec2 const endA = atA.centre + rotated(joined.anchors.onA, atA.angle);
    Vec2 const endB = atB.centre + rotated(joined.anchors.onB, atB.angle);
    double const distance = length(endB - endA);
    if (distance < joined.anchors.length || distance < shortestRope) {
        return;
    }
    Vec2 const pull = (joined.flipped ? -1 : 1) / distance * (endB - endA); // on ODE's first body
    dContact contact{};
    contact.geom.normal[0] = pull.x;
    contact.geom.normal[1] = pull.y;
    contact.geom.pos[0] = endA.x;
    contact.geom.pos[1] = endA.y;
    contact.geom.depth = distance - joined.anchors.length + skinDepth;
    dJointID const joint = dJointCreateContact(world_.get(), contacts_.get(), &contact);
    dJointAttach(joint, idOf(joined.flipped ? joined.b : joined.a),
                 idOf(joined.flipped ? joined.a : joined.b));
    dJointSetFeedback(joint, joined.feedback.get());
}

void OdeEngine::solveRows(double h, int iterations) {
    struct Solved {
        JointRows* rows = nullptr;
        std::array<double, 4> inverseMass{};
        std::array<double, 4> inverseInertia{};
    };
    std::vector<Solved> all;
    for (auto const& joined : joined_) {
        if (!joined || !asRows(joined->joint.form)) {
            continue;
        }
        Solved solved{.rows = &*joined->rows};
        std::array<JointPose, 4> poses;
        std::span<SlotIndex const> const slots = joined->rows->slots();
        bool anyAwake = false;
        for (std::size_t i = 0; i < slots.size(); ++i) {
            Motion const motion = motionOrOrigin(slots[i]);
            if (moves(slots[i])) {
                solved.inverseMass[i] = 1 / bodies()[slots[i]].mass;
                solved.inverseInertia[i] = 1 / bodies()[slots[i]].inertia;
                anyAwake = anyAwake || isAwake(slots[i]);
            }
            poses[i] = {motion.centre, motion.angle, solved.inverseMass[i], solved.inverseInertia[i]};
        }
        if (anyAwake) {
            joined->rows->prepare({poses.data(), slots.size()}, h);
            all.push_back(solved);
        }
    }
    if (all.empty()) {
        return;
    }
    std::vector<Motion> shove(motions_.size()); // corrects position errors without adding energy
    auto const push = [&](Solved const& solved, JointRow const& row, double impulse,
                          std::vector<Motion>& on) {
        for (int i = 0; i < row.count; ++i) {
            RowTerm const& term = row.terms[static_cast<std::size_t>(i)];
            auto const body = static_cast<std::size_t>(term.body);
            SlotIndex const slot = solved.rows->slots()[body];
            if (moves(slot)) {
                on[slot].velocity += solved.inverseMass[body] * impulse * term.linear;
                on[slot].spin += solved.inverseInertia[body] * impulse * term.angular;
            }
        }
    };
    auto const speedOf = [&](Solved const& solved, JointRow const& row, std::vector<Motion> const& on) {
        double sum = 0;
        for (int i = 0; i < row.count; ++i) {
            RowTerm const& term = row.terms[static_cast<std::size_t>(i)];
            SlotIndex const slot = solved.rows->slots()[static_cast<std::size_t>(term.body)];
            if (moves(slot)) {
                sum += dot(term.linear, on[slot].velocity) + term.angular * on[slot].spin;
            }
        }
        return sum;
    };
    for (Solved const& solved : all) {
        for (JointRow const& row : solved.rows->rows()) {
            push(solved, row, row.impulse, motions_);
        }
    }
    for (int i = 0; i < iterations; ++i) {
        for (Solved const& solved : all) {
            for (JointRow& row : solved.rows->rows()) {
                if (row.mass == 0) {
                    continue;
                }
                push(solved, row, row.solve(speedOf(solved, row, motions_)), motions_);
                if (row.corrects) {
                    push(solved, row, row.solveCorrection(speedOf(solved, row, shove)), shove);
                }
            }
        }
    }
    for (SlotIndex const slot : awakeSlots_) {
        motions_[slot].centre += h * shove[slot].velocity;
        motions_[slot].angle += h * shove[slot].spin;
    }
}

void OdeEngine::noteJointImpulses(double h) {
    for (auto const& joined : joined_) {
        if (!joined) {
            continue;
        }
        if (asRows(joined->joint.form)) {
            joined->impulse = joined->rows->impulseOnA();
            continue;
        }
        dReal const* const onFirst = joined->feedback->f1;
        joined->impulse = (joined->flipped ? -h : h) * Vec2{onFirst[0], onFirst[1]};
    }
}

} // namespace trembler
#endif
