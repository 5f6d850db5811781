#ifdef TREMBLER_HAS_CHIPMUNK
#include "physics/dynamics/engines/chipmunk/chipmunk_joint.hpp"

#include "physics/dynamics/engines/chipmunk/chipmunk_engine.hpp"

#include <cmath>

namespace trembler {
namespace {

ChipmunkJoint& jointOf(cpConstraint* constraint) {
    return *static_cast<ChipmunkJoint*>(constraint);
}

cpBody& bodyOf(ChipmunkJoint const& joint, RowTerm const& term) {
    return *joint.bodies[static_cast<std::size_t>(term.body)];
}

void push(ChipmunkJoint const& joint, JointRow const& row, double impulse) {
    for (int i = 0; i < row.count; ++i) {
        RowTerm const& term = row.terms[static_cast<std::size_t>(i)];
        cpBody& body = bodyOf(joint, term);
        body.v.x += body.m_inv * impulse * term.linear.x;
        body.v.y += body.m_inv * impulse * term.linear.y;
        body.w += body.i_inv * impulse * term.angular;
    }
}

void prepare(cpConstraint* constraint, cpFloat h) {
    ChipmunkJoint& joint = jointOf(constraint);
    std::array<JointPose, 4> poses;
    for (std::size_t i = 0; i < joint.bodies.size(); ++i) {
        cpBody const& body = *joint.bodies[i];
        poses[i] = {{body.p.x, body.p.y}, body.a, body.m_inv, body.i_inv};
    }
    joint.rows.prepare({poses.data(), joint.bodies.size()}, h);
}

void applyKept(cpConstraint* constraint, cpFloat stretch) {
    ChipmunkJoint& joint = jointOf(constraint);
    for (JointRow& row : joint.rows.rows()) {
        row.impulse *= stretch; // the length of this step relative to the last one
        push(joint, row, row.impulse);
    }
}

void apply(cpConstraint* constraint, cpFloat /*h*/) {
    ChipmunkJoint& joint = jointOf(constraint);
    for (JointRow& row : joint.rows.rows()) {
        if (row.mass == 0) {
            continue;
        }
        double speed = 0;
        double correction = 0;
        for (int i = 0; i < row.count; ++i) {
            RowTerm const& term = row.terms[static_cast<std::size_t>(i)];
            cpBody const& body = bodyOf(joint, term);
            speed += term.linear.x * body.v.x + term.linear.y * body.v.y + term.angular * body.w;
            correction +=
                term.linear.x * body.v_bias.x + term.linear.y * body.v_bias.y + term.angular * body.w_bias;
        }
        push(joint, row, row.solve(speed));
        if (row.corrects) {
            double const shove = row.solveCorrection(correction);
            for (int i = 0; i < row.count; ++i) {
                RowTerm const& term = row.terms[static_cast<std::size_t>(i)];
                cpBody& body = bodyOf(joint, term);
                body.v_bias.x += body.m_inv * shove * term.linear.x;
                body.v_bias.y += body.m_inv * shove * term.linear.y;
                body.w_bias += body.i_inv * shove * term.angular;
            }
        }
    }
}

cpFloat impulseOf(cpConstraint* constraint) {
    return length(jointOf(constraint).rows.impulseOnA());
}

constexpr cpConstraintClass rowsClass{prepare, applyKept, apply, impulseOf};

} // namespace

ChipmunkJoint::ChipmunkJoint(cpBody* first, cpBody* second, JointRows joint, std::vector<cpBody*> all,
                             bool collide)
    : cpConstraint{}, rows(std::move(joint)), bodies(std::move(all)) {
    klass = &rowsClass;
    a = first;
    b = second;
    maxForce = INFINITY;
    maxBias = INFINITY;
    errorBias = 0.5; // has no effect here, but Chipmunk checks it
    collideBodies = collide ? cpTrue : cpFalse;
}

void ChipmunkEngine::JointFree::operator()(ChipmunkJoint* joint) const {
    delete joint;
}

void ChipmunkEngine::makeJoint(SlotIndex slot, JointSpec const& spec) {
    if (joints_.size() <= slot) {
        joints_.resize(slot + std::size_t{1});
    }
    bool const gear = spec.joint->form == JointForm::gear;
    JointRows rows(spec, gear ? &joints_[spec.gearA]->rows : nullptr,
                   gear ? &joints_[spec.gearB]->rows : nullptr);
    std::vector<cpBody*> all;
    for (SlotIndex const body : rows.slots()) {
        all.push_back(body == noSlot ? cpSpaceGetStaticBody(space_.get()) : bodies_[body]);
    }
    cpBody* const second = spec.b == noSlot ? cpSpaceGetStaticBody(space_.get()) : bodies_[spec.b];
    joints_[slot].reset(
        new ChipmunkJoint(bodies_[spec.a], second, std::move(rows), std::move(all), spec.joint->collide));
    cpSpaceAddConstraint(space_.get(), joints_[slot].get());
}

void ChipmunkEngine::dropJoint(SlotIndex slot) {
    cpSpaceRemoveConstraint(space_.get(), joints_[slot].get());
    joints_[slot].reset();
}

Vec2 ChipmunkEngine::jointImpulse(SlotIndex slot) const {
    return joints_[slot]->rows.impulseOnA();
}

} // namespace trembler
#endif
