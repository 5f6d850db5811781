// The properties that Magnetism adds to new objects.
#pragma once

#include "physics/depth.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/material.hpp"
#include "runtime/component/completion.hpp"
#include "runtime/object/without.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {

/// A piece saturated by a strong magnet has poles whose strength is its magnetisation times its cross-section
/// (Cullity and Graham 2009, Chapter 1). The cross-section is that of a square of the same area, as deep as
/// the world.
struct SusceptibilityCompletion final
    : Completion<SusceptibilityCompletion, Reads<MadeOf, Without, Shape>, Adds<MagneticStrength>> {
    static constexpr CompletionText text{
        .name = "Susceptibility",
        .work = "Makes magnets attract an object of iron or steel, unless it is stated that they do not. Its "
                "susceptibility is the saturation times the root of its area times the depth of the world."};
    using Activation = NeedsAll<MadeOf, Shape>;
    static void complete(Access& access) {
        double const saturation = materialFacts(access.find<MadeOf>()->material).saturation;
        Shape const& shape = *access.find<Shape>();
        if (saturation > 0 && !isWithout<MagneticStrength>(access.find<Without>()) && !faultIn(shape)) {
            double const poles = saturation * std::sqrt(areaOf(shape)) * worldDepth;
            access.add(MagneticStrength{.strength = 0, .susceptibility = std::min(poles, 1e8)});
        }
    }
};

struct MagnetCompletion final
    : Completion<MagnetCompletion, Reads<Electromagnet, MagneticPoles>, Adds<Magnet>> {
    static constexpr CompletionText text{
        .name = "Magnet",
        .work =
            "Makes an object with poles a magnet: an electromagnet is off at first, any other magnet is on."};
    using Activation = NeedsAny<Electromagnet, MagneticPoles>;
    static void complete(Access& access) {
        access.add(access.has<Electromagnet>() ? Magnet{false, 0} : Magnet{});
    }
};

} // namespace trembler
