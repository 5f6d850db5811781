// An interaction calls a function of a resolver that is not its own.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct HeatFromGlow final : Interaction<HeatFromGlow, HeatRole, Reads<Glow>> {
    static constexpr ComponentText text{
        .name = "Heat <- Glow", .effect = "heat", .level = "", .work = "Heats."};
    using Activation = NeedsAll<>;
    void apply(Access& access) {
        access.call(AddHeat{ObjectId{0, 0}, 1});
#ifndef TREMBLER_CONTROL
        access.call(Paint{ObjectId{0, 0}});
#endif
    }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<HeatFromGlow>();

} // namespace trembler
