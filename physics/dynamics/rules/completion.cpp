#include "physics/dynamics/rules/completion.hpp"

#include "physics/dynamics/properties/shapes/mass_properties.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"

namespace trembler {

void MatterCompletion::complete(Access& access) {
    MaterialFacts const& facts = materialFacts(access.find<MadeOf>()->material);
    Without const* const without = access.find<Without>();
    if (!isWithout<Density>(without)) {
        access.add(Density{facts.density});
    }
    if (!isWithout<Friction>(without)) {
        access.add(Friction{facts.friction});
    }
    if (!isWithout<Restitution>(without)) {
        access.add(Restitution{facts.restitution});
    }
}

void BodyCompletion::complete(Access& access) {
    access.add(Rotation{});
    if (!access.has<Fixed>() && !access.has<Liquid>()) {
        access.add(Velocity{});
        access.add(AngularVelocity{});
    }
    Shape const& shape = *access.find<Shape>();
    if (access.has<Mass>() || faultIn(shape)) {
        return;
    }
    access.add(Mass{massFromDensity(shape, access.find<Density>())});
}

} // namespace trembler
