#include "physics/dynamics/core/joints.hpp"

#include "physics/dynamics/rules/joint_rules.hpp"

#include <algorithm>

namespace trembler {

void JointTable::removeOutdated(DynamicsColumns const& columns, std::span<SlotIndex const> going,
                                Engine& engine) {
    auto const goes = [&](SlotIndex body) { return std::binary_search(going.begin(), going.end(), body); };
    std::vector<bool> out(joints_.size(), false);
    for (std::size_t slot = 0; slot < joints_.size(); ++slot) {
        TiedJoint const& tied = joints_[slot];
        if (!tied.object.valid()) {
            continue;
        }
        Joint const* const joint = columns.joint.find(tied.object);
        JointAnchors const* const anchors = columns.anchors.find(tied.object);
        out[slot] = joint == nullptr || anchors == nullptr || !(*joint == tied.joint) ||
                    !(*anchors == tied.anchors) || goes(tied.a) || goes(tied.b);
    }
    for (std::size_t slot = 0; slot < joints_.size();
         ++slot) { // gears are removed before the joints that they couple
        TiedJoint const& tied = joints_[slot];
        if (tied.object.valid() && tied.gearA != noSlot &&
            (out[slot] || out[tied.gearA] || out[tied.gearB])) {
            remove(static_cast<SlotIndex>(slot), engine);
            out[slot] = false;
        }
    }
    for (std::size_t slot = 0; slot < joints_.size(); ++slot) {
        if (out[slot]) {
            remove(static_cast<SlotIndex>(slot), engine);
        }
    }
}

void JointTable::remove(SlotIndex slot, Engine& engine) {
    engine.removeJoint(slot);
    slots_.release(slot);
    joints_[slot] = {};
}

void JointTable::addMissing(DynamicsColumns const& columns, BodyTable const& bodies, Engine& engine,
                            std::vector<Refusal>& refusals) {
    for (bool const gears : {false, true}) {
        std::span<ObjectId const> const owners = columns.joint.owners();
        for (std::size_t row = 0; row < owners.size(); ++row) {
            Joint const& joint = columns.joint.values()[row];
            if ((joint.form == JointForm::gear) == gears && slots_.find(owners[row]) == noSlot) {
                add(columns, bodies, owners[row], joint, engine, refusals);
            }
        }
    }
}

void JointTable::add(DynamicsColumns const& columns, BodyTable const& bodies, ObjectId id, Joint const& joint,
                     Engine& engine, std::vector<Refusal>& refusals) {
    TiedJoint tied{.object = id,
                   .joint = joint,
                   .anchors = {},
                   .a = bodies.slotOf(joint.a),
                   .b = bodies.slotOf(joint.b),
                   .gearA = noSlot,
                   .gearB = noSlot};
    JointPartners const partners{.aIsBody = tied.a != noSlot,
                                 .bIsBody = tied.b != noSlot,
                                 .aFixed = tied.a != noSlot && bodies[tied.a].fixed,
                                 .bFixed = tied.b != noSlot && bodies[tied.b].fixed,
                                 .jointA = columns.joint.find(joint.jointA),
                                 .jointB = columns.joint.find(joint.jointB)};
    std::optional<std::string> fault = faultIn(joint, partners);
    JointAnchors const* const anchors = columns.anchors.find(id);
    if (!fault && anchors == nullptr) {
        fault = "it has no anchors, as its objects had no place when it came into being";
    }
    if (!fault && joint.form == JointForm::gear) {
        tied.gearA = slots_.find(joint.jointA);
        tied.gearB = slots_.find(joint.jointB);
        if (tied.gearA == noSlot || tied.gearB == noSlot) {
            fault = "a joint that it couples is not at work";
        }
    }
    if (fault) {
        refusals.push_back({id, *fault});
        return;
    }
    tied.anchors = *anchors;
    SlotIndex const slot = slots_.take(id);
    joints_.resize(slots_.objects().size());
    joints_[slot] = tied;
    JointSpec spec{.joint = &joints_[slot].joint,
                   .anchors = tied.anchors,
                   .a = tied.a,
                   .b = tied.b,
                   .gearA = tied.gearA,
                   .gearB = tied.gearB};
    spec.anchors.onA -= bodies[tied.a].centre;
    if (tied.b != noSlot) {
        spec.anchors.onB -= bodies[tied.b].centre;
    }
    engine.addJoint(slot, spec);
}

} // namespace trembler
