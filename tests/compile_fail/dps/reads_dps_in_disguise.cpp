// A derived property set lists its reads in a type other than Reads<>, to circumvent the check in
// reads_dps.cpp.
#include "tests/compile_fail/kit.hpp"

#include <tuple>

namespace trembler {

#ifdef TREMBLER_CONTROL
using Request = Reads<Heat, HotSpots>;
#else
using Request = std::tuple<Heat, Shadow>;
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
