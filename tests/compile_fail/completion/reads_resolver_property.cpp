// A completion reads a property of a resolver, which has not run when objects are completed.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Seen = Reads<Colour>;
#else
using Seen = Reads<Colour, HotSpots>;
#endif

void add(Registry& registry) {
    registry.completion<WarmthAfter<Seen>>();
}

} // namespace trembler
