// (Frame <- Magnetic Forces): magnets that are strong for their mass ask for parts of a frame.
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/force_rates.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/frame/calls.hpp"

#include <algorithm>

namespace trembler {

/// Dynamics asks on behalf of all forces, but receives them a frame later. Between magnets that pass through
/// each other one frame is enough to gain energy.
class FrameFromMagneticForces final
    : public Interaction<FrameFromMagneticForces, FrameRole, Reads<MagneticForce, Fixed>> {
public:
    static constexpr ComponentText text{
        .name = "Frame <- Magnetic Forces",
        .effect = "magnetism",
        .level = "",
        .work =
            "Asks for parts of a frame so short that the forces between the strongest magnets are followed."};
    using Activation = NeedsAll<Shape>; // forces move bodies only
    void apply(Access& access) {
        auto const& fixed = access.read<Fixed>();
        double most = 0;
        for (MagneticForce::Rate const& one : access.read<MagneticForce>().rates) {
            most = std::max(most, fixed.has(one.object) ? 0.0 : one.rate);
        }
        if (most > 0 && longestPart(most) < frameDuration) { // a whole frame need not be asked for
            access.call(SplitFrame{longestPart(most)});
        }
    }
};

} // namespace trembler
