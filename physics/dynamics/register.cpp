#include "physics/dynamics/register.hpp"

#include "physics/dynamics/core/dynamics_resolver.hpp"
#include "physics/dynamics/engines/box2d/box2d_dynamics.hpp"
#include "physics/dynamics/engines/chipmunk/chipmunk_dynamics.hpp"
#include "physics/dynamics/engines/native/native_dynamics.hpp"
#include "physics/dynamics/engines/ode/ode_dynamics.hpp"
#include "physics/dynamics/interactions/frame_from_dynamics.hpp"
#include "physics/dynamics/interactions/from_player.hpp"
#include "physics/dynamics/interactions/population_from_dynamics.hpp"
#include "physics/dynamics/properties/joint_check.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "physics/dynamics/rules/completion.hpp"
#include "physics/dynamics/rules/crowd_rules.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {
namespace {

std::optional<std::string> checkShape(Store const& store, ObjectId id) {
    return faultIn(*store.findColumn<Shape>()->find(id));
}

std::optional<std::string> checkJoint(Store const& store, ObjectId id) {
    return refuseJoint(store, *store.findColumn<Joint>()->find(id));
}

} // namespace

void registerDynamics(Registry& registry) {
    registry.property<Density>();
    registry.rule({&propertyInfo<Shape>(), checkShape});
    registry.rule({&propertyInfo<Joint>(), checkJoint});
    registry.rule({.property = &propertyInfo<Position>(), .checkAll = checkCrowds});
    registry.completion<MatterCompletion>();
    registry.completion<BodyCompletion>();
    registry.completion<JointCompletion>();
    registry.component<DynamicsResolver>(box2dDynamics);
    registry.component<DynamicsResolver>(chipmunkDynamics);
    registry.component<DynamicsResolver>(odeDynamics);
    registry.component<DynamicsResolver>(nativeDynamics);
    registry.component<DynamicsFromPlayer>();
    registry.component<FrameFromDynamics>();
    registry.component<PopulationFromDynamics>();
}

} // namespace trembler
