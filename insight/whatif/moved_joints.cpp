#include "insight/whatif/moved_joints.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint_anchors.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <vector>

namespace trembler::insight {
namespace {

/// The frame of an object, or, of an invalid one, of the world.
struct AnchorFrame {
    Vec2 origin;
    double angle = 0;

    [[nodiscard]] Vec2 world(Vec2 local) const { return origin + rotated(local, angle); }
    [[nodiscard]] Vec2 local(Vec2 point) const { return rotated(point - origin, -angle); }
};

AnchorFrame frameOf(Store const& store, ObjectId object) {
    auto const* const positions = store.findColumn<Position>();
    auto const* const rotations = store.findColumn<Rotation>();
    Position const* const position = positions == nullptr ? nullptr : positions->find(object);
    Rotation const* const rotation = rotations == nullptr ? nullptr : rotations->find(object);
    return {position == nullptr ? Vec2{} : position->value, rotation == nullptr ? 0 : rotation->angle};
}

Vec2 movedAnchor(AnchorFrame const& frame, Vec2 local, PartMotion const& motion) {
    bool const ofWorld = frame.origin == Vec2{} && frame.angle == 0; // whose points need no conversion
    return ofWorld ? motion.point(local) : frame.local(motion.point(frame.world(local)));
}

/// Whether both objects are held at one and the same point, or along one line.
bool hasOnePoint(JointForm form) {
    return form == JointForm::hinge || form == JointForm::weld || form == JointForm::slider ||
           form == JointForm::wheel;
}

void movePoints(Joint& joint, PartMotion const& motion) {
    for (Vec2* const point : {&joint.at, &joint.atB, &joint.groundA, &joint.groundB}) {
        *point = motion.point(*point);
    }
    joint.axis = motion.direction(joint.axis);
}

} // namespace

void moveJoints(Store& store, std::span<ObjectId const> moved, PartMotion const& motion) {
    if (store.findColumn<Joint>() == nullptr || store.findColumn<JointAnchors>() == nullptr) {
        return;
    }
    auto const isMoved = [&](ObjectId id) { return std::binary_search(moved.begin(), moved.end(), id); };
    auto& joints = store.column<Joint>();
    auto& columnOfAnchors = store.column<JointAnchors>();
    std::vector<ObjectId> const owners(joints.owners().begin(), joints.owners().end());
    for (ObjectId const id : owners) {
        Joint joint = joints[id];
        JointAnchors const* const before = columnOfAnchors.find(id);
        bool const movesA = isMoved(joint.a);
        bool const movesB = isMoved(joint.b);
        bool const ofPart = isMoved(id);
        if (before == nullptr || (!movesA && !movesB)) {
            continue;
        }
        if (movesA && movesB) { // its anchors move with its objects
            if (ofPart && joint.form == JointForm::pulley) {
                movePoints(joint, motion);
                joints.set(id, joint);
            }
            continue;
        }
        ObjectId const stays = movesA ? joint.b : joint.a;
        bool const held = !stays.valid() || store.has<Fixed>(stays);
        if (!held || !(ofPart || hasOnePoint(joint.form))) {
            continue;
        }
        JointAnchors anchors = *before;
        AnchorFrame const frame = frameOf(store, stays);
        if (movesA) {
            anchors.onB = movedAnchor(frame, anchors.onB, motion);
            anchors.axis = motion.direction(anchors.axis);
            anchors.referenceAngle += motion.turn;
        } else {
            anchors.onA = movedAnchor(frame, anchors.onA, motion);
            anchors.referenceAngle -= motion.turn;
        }
        movePoints(joint, motion);
        joints.set(id, joint);
        columnOfAnchors.set(id, anchors);
    }
}

} // namespace trembler::insight
