// A derived property set declares to read the property of another one.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Request = Reads<Heat, HotSpots>;
#else
using Request = Reads<Heat, Shadow>;
#endif
struct Shine final : Dps<Shine, Request, Derives<Glow>> {
    static constexpr ComponentText text{.name = "Shine", .effect = "heat", .level = "", .work = "Glows."};
    using Activation = NeedsAll<Heat>;
    void update(Access& access) { access.derive<Glow>().watts.clear(); }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Shine>();

} // namespace trembler
