// A derived property set circumvents its declarations to access the store.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Shine final : Dps<Shine, Reads<Heat>, Derives<Glow>> {
    static constexpr ComponentText text{.name = "Shine", .effect = "heat", .level = "", .work = "Glows."};
    using Activation = NeedsAll<Heat>;
#ifndef TREMBLER_CONTROL
    void bind(Store&, Channels&) override {}
#endif
    void update(Access& access) {
        access.derive<Glow>().watts.clear();
    }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Shine>();

} // namespace trembler
