// (Frame <- Dynamics): forces that vary much within a frame request frames in parts.
#pragma once

#include "physics/dynamics/properties/force_rates.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/frame/calls.hpp"

namespace trembler {

class FrameFromDynamics final : public Interaction<FrameFromDynamics, FrameRole, Reads<ForceRates>> {
public:
    static constexpr ComponentText text{
        .name = "Frame <- Dynamics",
        .effect = "dynamics",
        .level = "",
        .work = "Requests parts of a frame that are short enough for the force that varies fastest."};
    using Activation = NeedsAll<>;
    void apply(Access& access) {
        double const rate = access.read<ForceRates>().swinging;
        if (rate > 0 && longestPart(rate) < frameDuration) { // a whole frame need not be requested
            access.call(SplitFrame{longestPart(rate)});
        }
    }
};

} // namespace trembler
