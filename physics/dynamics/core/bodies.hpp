// The rigid bodies of an engine, kept consistent with the columns.
#pragma once

#include "physics/dynamics/core/columns.hpp"
#include "physics/dynamics/core/slots.hpp"

namespace trembler {

/// Rows of a body in the columns that Dynamics writes.
struct MotionRows {
    std::uint32_t position = ColumnBase::absent;
    std::uint32_t rotation = ColumnBase::absent;
    std::uint32_t velocity = ColumnBase::absent;
    std::uint32_t spin = ColumnBase::absent;
};

/// The members that are read in every frame come first, and fill one cache line.
struct alignas(64) Body {
    ObjectId object; ///< invalid: the slot is free
    bool fixed = false;
    bool offCentre = false;
    Vec2 centre; ///< m, centre of mass in the object's frame
    MotionRows rows;
    double mass = 0;    ///< kg
    double inertia = 0; ///< kg m², about the centre of mass
    Shape shape;        // as the engine has received it, to notice changes
    BodySpec spec;
};

/// New bodies are added in ascending order of objects, independent of the order in which the objects were
/// created.
class BodyTable {
public:
    /// The bodies that must be removed: their object no longer exists, or one of the properties that they are
    /// made from has changed. Ascending slots.
    [[nodiscard]] std::vector<SlotIndex> outdated(DynamicsColumns const& columns) const;
    void remove(SlotIndex slot, Engine& engine);
    /// Adds every object that has a shape and no body yet. An invalid object is added to `refusals`.
    void addMissing(DynamicsColumns const& columns, Engine& engine, std::vector<Refusal>& refusals);
    /// Applies changes of the columns by others than this simulation.
    void followMotion(DynamicsColumns const& columns, Engine& engine);
    /// Finds the rows again after rows of any written column were added or removed.
    void findRows(DynamicsColumns const& columns);

    /// Makes these objects (ascending) fixed bodies, whatever they state, when they are next added.
    void standStill(std::vector<ObjectId> objects) { still_ = std::move(objects); }

    /// noSlot if the object has no body.
    [[nodiscard]] SlotIndex slotOf(ObjectId object) const { return slots_.find(object); }
    [[nodiscard]] std::span<Body const> bodies() const { return bodies_; }
    [[nodiscard]] Body const& operator[](SlotIndex slot) const { return bodies_[slot]; }
    /// Whether the slot, which may be noSlot, has a movable body.
    [[nodiscard]] bool moves(SlotIndex slot) const {
        return slot != noSlot && bodies_[slot].object.valid() && !bodies_[slot].fixed;
    }

private:
    SlotBook slots_;
    [[nodiscard]] BodySpec traitsOf(DynamicsColumns const& columns, ObjectId id) const;

    std::vector<Body> bodies_; // by slot
    std::vector<ObjectId> still_;
};

/// The centre of mass in the world, in m, of an object whose frame is at `position`, turned by `angle`.
[[nodiscard]] inline Vec2 worldCentre(Body const& body, Vec2 position, double angle) {
    return body.offCentre ? position + rotated(body.centre, angle) : position;
}

} // namespace trembler
