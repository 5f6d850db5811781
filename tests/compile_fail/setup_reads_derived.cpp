// An interaction that makes calls in the setup reads a property that is not derived by then.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct HeatFromGlow final : Interaction<HeatFromGlow, HeatRole, Reads<Glow>> {
    static constexpr ComponentText text{
        .name = "Heat <- Glow", .effect = "heat", .level = "", .work = "Heats."};
    using Activation = NeedsAll<>;
#ifndef TREMBLER_CONTROL
    static constexpr bool inSetup = true;
#endif
    void apply(Access&) {}
};

void add(Registry& registry) {
    registry.component<HeatFromGlow>();
}

} // namespace trembler
