// An interaction reads a property that is not in its Reads<>.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct HeatFromGlow final : Interaction<HeatFromGlow, HeatRole, Reads<Glow>> {
    static constexpr ComponentText text{
        .name = "Heat <- Glow", .effect = "heat", .level = "", .work = "Heats."};
    using Activation = NeedsAll<>;
    void apply(Access& access) {
        access.call(AddHeat{ObjectId{0, 0}, static_cast<double>(access.read<Glow>().watts.size())});
#ifndef TREMBLER_CONTROL
        access.call(AddHeat{ObjectId{0, 0}, access.read<Shadow>().area});
#endif
    }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<HeatFromGlow>();

} // namespace trembler
