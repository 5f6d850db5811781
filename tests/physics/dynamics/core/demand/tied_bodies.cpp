#include "tests/physics/dynamics/core/demand/tied_bodies.hpp"

#include <gtest/gtest.h>

namespace trembler::test {

class TiedBodies::Engine final : public trembler::Engine {
public:
    void addBody(SlotIndex, BodySpec const&) override {}
    void removeBody(SlotIndex) override {}
    void addJoint(SlotIndex, JointSpec const&) override {}
    void removeJoint(SlotIndex) override {}
    void place(SlotIndex, Motion const&) override {}
    [[nodiscard]] bool isAt(SlotIndex, Motion const&) const override { return true; }
    void setLoads(std::span<Load const>) override {}
    void setDrags(std::span<Drag const>) override {}
    void wake(SlotIndex) override {}
    void applyImpulse(SlotIndex, Vec2, Vec2) override {}
    [[nodiscard]] std::span<std::uint8_t const> awake() const override { return {}; }
    [[nodiscard]] bool anyAwake() const override { return false; }
    void step(double, DynamicsSettings const&) override { FAIL() << "step() must not be called"; }
    [[nodiscard]] std::span<MovedBody const> moved() const override { return {}; }
    [[nodiscard]] std::vector<TouchChange>& touchChanges() override { return changes_; }
    void addContactPatches(std::vector<ContactPatch>&) const override {}
    [[nodiscard]] Vec2 jointForce(SlotIndex) const override { return {}; }

private:
    std::vector<TouchChange> changes_;
};

ObjectId TiedBodies::body(Shape shape, Vec2 at, double mass, double angle) {
    ObjectId const id = create();
    shapes_.set(id, std::move(shape));
    masses_.set(id, Mass{mass});
    positions_.set(id, Position{at});
    rotations_.set(id, Rotation{angle});
    velocities_.set(id, Velocity{});
    spins_.set(id, AngularVelocity{});
    return id;
}

ObjectId TiedBodies::fixed(Vec2 at) {
    ObjectId const id = create();
    shapes_.set(id, Shape{{boxPiece(1, 1)}});
    positions_.set(id, Position{at});
    fixed_.set(id, Fixed{});
    return id;
}

ObjectId TiedBodies::joint(Joint joint) {
    ObjectId const id = create();
    auto const local = [&](ObjectId object, Vec2 point) {
        if (!object.valid()) {
            return point;
        }
        double const angle = rotations_.has(object) ? rotations_[object].angle : 0;
        return rotated(point - positions_[object].value, -angle);
    };
    JointAnchors anchors;
    anchors.onA = local(joint.a, joint.at);
    anchors.onB = local(joint.b, joint.atB);
    tied_.set(id, joint);
    anchors_.set(id, anchors);
    return id;
}

ObjectId TiedBodies::joint(JointForm form, ObjectId a, ObjectId b, Vec2 at) {
    Joint made;
    made.form = form;
    made.a = a;
    made.b = b;
    made.at = made.atB = at;
    made.length = 1;
    made.stiffness = 1000;
    made.ratio = 1;
    made.groundA = at + Vec2{-1, 5};
    made.groundB = at + Vec2{1, 5};
    return joint(made);
}

void TiedBodies::remove(ObjectId joint) {
    tied_.remove(joint);
    anchors_.remove(joint);
}

void TiedBodies::pull(ObjectId body, Vec2 force) {
    forces_.push_back({body, force});
}

void TiedBodies::weigh(Vec2 acceleration) {
    for (ObjectId const id : masses_.owners()) {
        pull(id, masses_[id].value * acceleration);
    }
}

void TiedBodies::settle() {
    Engine engine;
    std::vector<Refusal> refusals;
    joints_.removeOutdated(columns(), {}, engine);
    bodies_.addMissing(columns(), engine, refusals);
    bodies_.findRows(columns());
    joints_.addMissing(columns(), bodies_, engine, refusals);
    for (Refusal const& refusal : refusals) {
        ADD_FAILURE() << refusal.why;
    }
}

DynamicsColumns TiedBodies::columns() const {
    return {shapes_,   masses_, fixed_,   liquids_,  bullets_,   frictions_, restitutions_, groups_,
            dampings_, tied_,   anchors_, settings_, positions_, rotations_, velocities_,   spins_};
}

std::vector<LoadSum> TiedBodies::loads() const {
    LoadTable table;
    table.clear(bodies_.bodies().size());
    for (Force const& force : forces_) {
        table.add(bodies_.slotOf(force.body), force.force, 0);
    }
    return {table.sums().begin(), table.sums().end()};
}

SlotIndex TiedBodies::slotOf(ObjectId joint) const {
    for (std::size_t slot = 0; slot < joints_.joints().size(); ++slot) {
        if (joints_.joints()[slot].object == joint) {
            return static_cast<SlotIndex>(slot);
        }
    }
    return noSlot;
}

} // namespace trembler::test
