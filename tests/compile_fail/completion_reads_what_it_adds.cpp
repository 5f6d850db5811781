// A completion reads what it adds: of other objects that would depend on who is completed first.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Seen = Reads<Colour>;
#else
using Seen = Reads<Colour, Heat>;
#endif
struct Warmth final : Completion<Warmth, Seen, Adds<Heat>> {
    static constexpr CompletionText text{.name = "Warmth", .work = "Warms."};
    using CalledFor = NeedsAll<Colour>;
    static void complete(Access& access) { access.add(Heat{}); }
};
template void Registry::completion<Warmth>();

} // namespace trembler
