// Adds InAir to new objects that are light enough.
#pragma once

#include "physics/buoyancy/properties/air.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "runtime/component/completion.hpp"
#include "runtime/object/without.hpp"

namespace trembler {

/// Air reduces the weight of an object by the quotient of their densities. A tenth or more is visible.
inline constexpr double lightInAir = 10 * Air{}.density; // kg/m³

struct AirCompletion final
    : Completion<AirCompletion, Reads<Density, Shape, Fixed, Liquid, Without>, Adds<InAir>> {
    static constexpr CompletionText text{
        .name = "Air",
        .work = "Has air act on a movable object with a shape whose density is less than ten times that of "
                "the Earth's air, unless it is stated that it does not."};
    using Activation = NeedsAll<Density, Shape>;
    static void complete(Access& access) {
        if (access.find<Density>()->value < lightInAir && !access.has<Fixed>() && !access.has<Liquid>() &&
            !isWithout<InAir>(access.find<Without>())) {
            access.add(InAir{});
        }
    }
};

} // namespace trembler
