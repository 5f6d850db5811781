#include "physics/dynamics/rules/completion.hpp"

#include "physics/depth.hpp"
#include "physics/dynamics/properties/shape_rules.hpp"

#include <algorithm>

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
    Density const* const stated = access.find<Density>();
    double const density = (stated == nullptr ? Density{} : *stated).value;
    access.add(Mass{std::clamp(density * areaOf(shape) * worldDepth, 1e-6, 1e9)});
}

} // namespace trembler
