// The points where a joint holds its objects, in the objects' frames, so that they stay constant when the
// objects move.
#pragma once

#include "physics/dynamics/properties/joint.hpp"
#include "runtime/component/completion.hpp"
#include "runtime/placement.hpp"

namespace trembler {

/// Set when the joint is created, so that any engine can continue the simulation at any later time. Without
/// object b, its frame is the world's.
struct JointAnchors {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Joint anchors", "joint_anchors",
                                       "The points of its objects at which a joint acts, in their frames.",
                                       PropertyPlace::hidden};
    Vec2 onA;                  ///< m, in the frame of a
    Vec2 onB;                  ///< m, in the frame of b
    Vec2 axis{1, 0};           ///< unit, in the frame of b
    double referenceAngle = 0; ///< rad, angle of a minus angle of b at the start
    double length = 0;         ///< m: distance, rope, spring; pulley: the rope from a to its wheel
    double lengthB = 0;        ///< m: pulley: the rope from b to its wheel

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "on_a", .unit = "m", .meaning = "anchor on a, in the frame of a"}, self.onA);
        visit(FieldInfo{.key = "on_b", .unit = "m", .meaning = "anchor on b, in the frame of b"}, self.onB);
        visit(FieldInfo{.key = "axis", .unit = "", .meaning = "axis of a slider or wheel, in the frame of b"},
              self.axis);
        visit(FieldInfo{.key = "reference_deg",
                        .unit = "rad",
                        .meaning = "angle of a minus angle of b at the start"},
              self.referenceAngle);
        visit(FieldInfo{.key = "length",
                        .unit = "m",
                        .meaning = "length at the start or as stated; of a pulley: of the rope to a"},
              self.length);
        visit(FieldInfo{.key = "length_b", .unit = "m", .meaning = "length of a pulley's rope to b"},
              self.lengthB);
    }
    friend bool operator==(JointAnchors const&, JointAnchors const&) = default;
};

/// A joint whose objects have no place gets no anchors.
struct JointCompletion final
    : Completion<JointCompletion, Reads<Joint, Position, Rotation>, Adds<JointAnchors>> {
    static constexpr CompletionText text{
        .name = "Joint",
        .work = "Computes the anchors of a joint from the positions of its objects when it is created."};
    using Activation = NeedsAll<Joint>;
    static void complete(Access& access);
};

} // namespace trembler
