// The joints of an engine, kept consistent with the columns.
#pragma once

#include "physics/dynamics/core/bodies.hpp"

namespace trembler {

struct TiedJoint {
    ObjectId object; ///< the joint; invalid: the slot is free
    Joint joint;
    JointAnchors anchors;
    SlotIndex a = noSlot;
    SlotIndex b = noSlot;
    SlotIndex gearA = noSlot;
    SlotIndex gearB = noSlot;
};

/// Joints are added in ascending order of objects, gears after all others.
class JointTable {
public:
    /// Removes the joints that no longer exist or have changed, or whose bodies are removed (`going`,
    /// ascending), and the gears that depend on them.
    void removeOutdated(DynamicsColumns const& columns, std::span<SlotIndex const> going, Engine& engine);
    /// Adds every joint that the engine does not have yet. An invalid joint is added to `refusals`.
    void addMissing(DynamicsColumns const& columns, BodyTable const& bodies, Engine& engine,
                    std::vector<Refusal>& refusals);
    /// By slot.
    [[nodiscard]] std::span<TiedJoint const> joints() const { return joints_; }

private:
    void add(DynamicsColumns const& columns, BodyTable const& bodies, ObjectId id, Joint const& joint,
             Engine& engine, std::vector<Refusal>& refusals);
    void remove(SlotIndex slot, Engine& engine);

    SlotBook slots_;
    std::vector<TiedJoint> joints_;
};

} // namespace trembler
