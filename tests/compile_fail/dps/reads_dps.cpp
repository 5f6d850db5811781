// A derived property set declares to read another one.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Wish = Reads<Heat, HotSpots>;
#else
using Wish = Reads<Heat, Shadow>;
#endif
struct Shine final : Dps<Shine, Wish, Derives<Glow>> {
    static constexpr ComponentText text{.name = "Shine", .effect = "heat", .level = "", .work = "Glows."};
    using CalledFor = NeedsAll<Heat>;
    void update(Access& access) { access.derive<Glow>().watts.clear(); }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Shine>();

} // namespace trembler
