#include "physics/dynamics/completion.hpp"

#include "physics/buoyancy/liquid.hpp"
#include "physics/depth.hpp"
#include "physics/dynamics/body.hpp"
#include "physics/dynamics/shape.hpp"
#include "physics/dynamics/shape_rules.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/store.hpp"

#include <algorithm>

namespace trembler {

void completeBody(Store& store, ObjectId id) {
    Shape const* const shape = store.column<Shape>().find(id);
    if (shape == nullptr) {
        return;
    }
    store.column<Rotation>().addDefault(id);
    if (store.column<Fixed>().has(id) || store.column<Liquid>().has(id)) {
        return; // what never moves needs no mass
    }
    store.column<Velocity>().addDefault(id);
    store.column<AngularVelocity>().addDefault(id);
    if (store.column<Mass>().has(id) || faultIn(*shape)) {
        return; // of an unsound shape there is no mass to speak of
    }
    Density const* const density = store.column<Density>().find(id);
    double const mass = (density == nullptr ? Density{} : *density).value * areaOf(*shape) * worldDepth;
    store.column<Mass>().set(id, {std::clamp(mass, 1e-6, 1e9)});
}

} // namespace trembler
