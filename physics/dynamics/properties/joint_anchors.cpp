#include "physics/dynamics/properties/joint_anchors.hpp"

namespace trembler {
namespace {

struct Frame {
    Vec2 origin;
    double angle = 0;

    [[nodiscard]] Vec2 local(Vec2 point) const { return rotated(point - origin, -angle); }
};

} // namespace

void JointCompletion::complete(Access& access) {
    if (access.has<JointAnchors>()) {
        return;
    }
    Joint const* const joint = access.find<Joint>();
    auto const frameOf = [&](ObjectId object, Frame& frame) {
        Position const* const position = access.find<Position>(object);
        Rotation const* const rotation = access.find<Rotation>(object);
        frame = {position == nullptr ? Vec2{} : position->value, rotation == nullptr ? 0 : rotation->angle};
        return position != nullptr;
    };
    Frame a;
    Frame b;
    if (!frameOf(joint->a, a) || (joint->b.valid() && !frameOf(joint->b, b))) {
        return;
    }
    bool const twoEnds = joint->form == JointForm::distance || joint->form == JointForm::rope ||
                         joint->form == JointForm::spring || joint->form == JointForm::pulley;
    JointAnchors anchors;
    anchors.onA = a.local(joint->at);
    anchors.onB = b.local(twoEnds ? joint->atB : joint->at);
    double const axisLength = length(joint->axis);
    anchors.axis = axisLength > 0 ? rotated(joint->axis / axisLength, -b.angle) : Vec2{1, 0};
    anchors.referenceAngle = a.angle - b.angle;
    if (joint->form == JointForm::pulley) {
        anchors.length = length(joint->at - joint->groundA);
        anchors.lengthB = length(joint->atB - joint->groundB);
    } else if (twoEnds) {
        anchors.length = joint->length > 0 ? joint->length : length(joint->atB - joint->at);
    }
    access.add(anchors);
}

} // namespace trembler
