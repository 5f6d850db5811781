#include "physics/dynamics/register.hpp"

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/core/dynamics_resolver.hpp"
#include "physics/dynamics/engines/box2d/box2d_dynamics.hpp"
#include "physics/dynamics/engines/chipmunk/chipmunk_dynamics.hpp"
#include "physics/dynamics/engines/native/native_dynamics.hpp"
#include "physics/dynamics/engines/ode/ode_dynamics.hpp"
#include "physics/dynamics/interactions/frame_from_dynamics.hpp"
#include "physics/dynamics/interactions/from_player.hpp"
#include "physics/dynamics/interactions/population_from_dynamics.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "physics/dynamics/rules/completion.hpp"
#include "physics/dynamics/rules/crowd_rules.hpp"
#include "physics/dynamics/rules/joint_rules.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {
namespace {

std::optional<std::string> checkShape(Store const& store, ObjectId id) {
    return faultIn(*store.findColumn<Shape>()->find(id));
}

std::optional<std::string> checkJoint(Store const& store, ObjectId id) {
    Joint const& joint = *store.findColumn<Joint>()->find(id);
    auto const find = [&]<class P>(ObjectId object, P const*) -> P const* {
        auto const* const column = store.findColumn<P>();
        return column == nullptr ? nullptr : column->find(object);
    };
    auto const isBody = [&](ObjectId object) {
        Shape const* const shape = find(object, static_cast<Shape const*>(nullptr));
        return shape != nullptr && !faultIn(*shape) &&
               find(object, static_cast<Liquid const*>(nullptr)) == nullptr &&
               find(object, static_cast<Position const*>(nullptr)) != nullptr;
    };
    auto const isFixed = [&](ObjectId object) {
        return find(object, static_cast<Fixed const*>(nullptr)) != nullptr;
    };
    return faultIn(joint, {.aIsBody = isBody(joint.a),
                           .bIsBody = isBody(joint.b),
                           .aFixed = isFixed(joint.a),
                           .bFixed = isFixed(joint.b),
                           .jointA = find(joint.jointA, static_cast<Joint const*>(nullptr)),
                           .jointB = find(joint.jointB, static_cast<Joint const*>(nullptr))});
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
    registry.component<DynamicsResolver>(nativeDynamics);
    registry.component<DynamicsResolver>(chipmunkDynamics);
    registry.component<DynamicsResolver>(odeDynamics);
    registry.component<DynamicsFromPlayer>();
    registry.component<FrameFromDynamics>();
    registry.component<PopulationFromDynamics>();
}

} // namespace trembler
