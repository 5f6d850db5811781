// A derived property set writes a property that another one derives.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Shine final : Dps<Shine, Reads<Heat>, Derives<Glow>> {
    static constexpr ComponentText text{.name = "Shine", .effect = "heat", .level = "", .work = "Glows."};
    using Activation = NeedsAll<Heat>;
    void update(Access& access) {
        access.derive<Glow>().watts.assign(access.read<Heat>().size(), 0);
#ifndef TREMBLER_CONTROL
        access.derive<Shadow>().area = 1;
#endif
    }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Shine>();

} // namespace trembler
