// A completion reads what belongs to a resolver, which has not run when objects are completed.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Seen = Reads<Colour>;
#else
using Seen = Reads<Colour, HotSpots>;
#endif
struct Warmth final : Completion<Warmth, Seen, Adds<Heat>> {
    static constexpr CompletionText text{.name = "Warmth", .work = "Warms."};
    using CalledFor = NeedsAll<Colour>;
    static void complete(Access& access) { access.add(Heat{}); }
};
template void Registry::completion<Warmth>();

} // namespace trembler
