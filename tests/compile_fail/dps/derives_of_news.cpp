// A derived property depends on news (a property that reports events), and does not declare how the values of
// a frame's parts are merged.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Seen = HotSpots;
#else
using Seen = Sparks;
#endif
struct Shine final : Dps<Shine, Reads<Seen>, Derives<Glow>> {
    static constexpr ComponentText text{.name = "Shine", .effect = "heat", .level = "", .work = "Glows."};
    using Activation = NeedsAll<Heat>;
    void update(Access& access) { access.derive<Glow>().watts.assign(access.read<Seen>().objects.size(), 1); }
};

void add(Registry& registry) {
    registry.component<Shine>();
}

} // namespace trembler
