// A component constructs a caller, or uses another component's name.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct HeatFromGlow final : Interaction<HeatFromGlow, HeatRole, Reads<Glow>> {
    static constexpr ComponentText text{
        .name = "Heat <- Glow", .effect = "heat", .level = "", .work = "Heats."};
    using Activation = NeedsAll<>;
    void apply(Access& access) {
        CallerId const me = access.caller();
#ifndef TREMBLER_CONTROL
        caller_ = CallerId::level();
#endif
        static_cast<void>(me);
    }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<HeatFromGlow>();

} // namespace trembler
