#include "physics/dynamics/interactions/population_from_dynamics.hpp"

namespace trembler {

void PopulationFromDynamics::apply(Access& access) {
    auto const& joints = access.read<Joint>();
    for (auto const& overloaded : access.read<OverloadedJoints>().entries) {
        access.call(DestroyObject{overloaded.joint}, overloaded.event);
    }
    auto const& shapes = access.read<Shape>();
    for (std::size_t row = 0; row < joints.size(); ++row) {
        Joint const& joint = joints.values()[row];
        bool const gear = joint.form == JointForm::gear;
        if (!shapes.has(joint.a) || (joint.b.valid() && !shapes.has(joint.b)) ||
            (gear && (!joints.has(joint.jointA) || !joints.has(joint.jointB)))) {
            access.call(DestroyObject{joints.owners()[row]});
        }
    }
}

} // namespace trembler
