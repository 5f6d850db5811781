// A component keeps state between its turns and does not declare how the state hash covers it.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct HeatFromColour final : Interaction<HeatFromColour, HeatRole, Reads<Colour>> {
    static constexpr ComponentText text{
        .name = "Heat <- Colour", .effect = "heat", .level = "", .work = "Heats."};
    using Activation = NeedsAll<Colour>;
    void apply(Access&) { told_ = true; }
#ifdef TREMBLER_CONTROL
    void hashMemory(StateHash& hash) const {
        hash.members(told_);
    }
#endif
private:
    bool told_ = false;
};

void add(Registry& registry) {
    registry.component<HeatFromColour>();
}

} // namespace trembler
