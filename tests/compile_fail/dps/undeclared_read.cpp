// A derived property set reads a property that is not in its Reads<>.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Shine final : Dps<Shine, Reads<Heat>, Derives<Glow>> {
    static constexpr ComponentText text{.name = "Shine", .effect = "heat", .level = "", .work = "Glows."};
    using Activation = NeedsAll<Heat>;
    void update(Access& access) {
        access.derive<Glow>().watts.assign(access.read<Heat>().size(), 0);
#ifndef TREMBLER_CONTROL
        access.derive<Glow>().watts.resize(access.read<Colour>().size());
#endif
    }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Shine>();

} // namespace trembler
