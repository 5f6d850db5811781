#include "physics/dynamics/properties/joint_check.hpp"

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "physics/dynamics/rules/joint_rules.hpp"
#include "runtime/placement.hpp"

namespace trembler {
namespace {

template <class P>
P const* stated(Store const& store, ObjectId object) {
    auto const* const column = store.findColumn<P>();
    return column == nullptr ? nullptr : column->find(object);
}

} // namespace

bool canBeJoined(Store const& store, ObjectId object) {
    Shape const* const shape = stated<Shape>(store, object);
    return shape != nullptr && !faultIn(*shape) && stated<Liquid>(store, object) == nullptr &&
           stated<Position>(store, object) != nullptr;
}

std::optional<std::string> refuseJoint(Store const& store, Joint const& joint) {
    return faultIn(joint, {.aIsBody = canBeJoined(store, joint.a),
                           .bIsBody = canBeJoined(store, joint.b),
                           .aFixed = stated<Fixed>(store, joint.a) != nullptr,
                           .bFixed = stated<Fixed>(store, joint.b) != nullptr,
                           .jointA = stated<Joint>(store, joint.jointA),
                           .jointB = stated<Joint>(store, joint.jointB)});
}

} // namespace trembler
