// A derived property set tries to write a resolver property.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Result = Derives<Glow>;
#else
using Result = Provides<HotSpots>;
#endif
struct Shine final : Dps<Shine, Reads<Heat>, Result> {
    static constexpr ComponentText text{.name = "Shine", .effect = "heat", .level = "", .work = "Glows."};
    using Activation = NeedsAll<Heat>;
    void update(Access&) {}
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Shine>();

} // namespace trembler
