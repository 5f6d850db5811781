// (Frame <- Magnetic Forces): magnets that are strong for their mass request frames in parts.
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/force_rates.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/frame/calls.hpp"

#include <algorithm>

namespace trembler {

/// Dynamics requests parts for all forces, but receives magnetic forces one frame later. Magnets that pass
/// through each other can gain energy in that one frame.
class FrameFromMagneticForces final
    : public Interaction<FrameFromMagneticForces, FrameRole, Reads<MagneticForce, Fixed>> {
public:
    static constexpr ComponentText text{
        .name = "Frame <- Magnetic Forces",
        .effect = "magnetism",
        .level = "",
        .work =
            "Requests parts of a frame that are short enough for the forces between the strongest magnets."};
    using Activation = NeedsAll<Shape>; // forces move bodies only
    void apply(Access& access) {
        auto const& fixed = access.read<Fixed>();
        double most = 0;
        for (MagneticForce::Rate const& one : access.read<MagneticForce>().rates) {
            most = std::max(most, fixed.has(one.object) ? 0.0 : one.rate);
        }
        if (most > 0 && longestPart(most) < frameDuration) { // a whole frame need not be requested
            access.call(SplitFrame{longestPart(most)});
        }
    }
};

} // namespace trembler
