// (Dynamics <- Liquid Drag): resistance to motion in a liquid, and the push of a current.
#pragma once

#include "physics/buoyancy/properties/liquid_resistance.hpp"
#include "physics/dynamics/calls.hpp"
#include "runtime/component/interaction.hpp"

namespace trembler {

class DynamicsFromLiquidDrag final
    : public Interaction<DynamicsFromLiquidDrag, DynamicsRole, Reads<LiquidResistance>> {
public:
    static constexpr ComponentText text{.name = "Dynamics <- Liquid Drag",
                                        .effect = "buoyancy",
                                        .level = "",
                                        .work =
                                            "Applies the resistance of liquids, and the push of their "
                                            "currents, to the objects in them; states how fast F_B varies."};
    using Activation = NeedsAll<>;
    void apply(Access& access) {
        auto const& entries = access.read<LiquidResistance>().entries;
        bool const foreseen = access.read<LiquidResistance>().foreseen;
        access.forChunks(entries.size(), [&](Caller& caller, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                LiquidResistance::Entry const& e = entries[i];
                caller.call(AddDrag{e.object, e.point, e.xx, e.xy, e.yy, e.angular}, e.event);
                if (e.rate > 0) {
                    // Here looking ahead is a resistance, which is stable with any step.
                    caller.call(StateRate{
                        .object = e.object, .rate = e.rate, .foreseen = foreseen, .swings = !foreseen});
                }
                if (!(e.push == Vec2{})) {
                    caller.call(AddForceToPoint{e.object, e.point, e.push}, e.event);
                }
            }
        });
    }
};

} // namespace trembler
