// A completion reads the property that it adds: for other objects the result would depend on the order of
// completion.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Seen = Reads<Colour>;
#else
using Seen = Reads<Colour, Heat>;
#endif

void add(Registry& registry) {
    registry.completion<WarmthAfter<Seen>>();
}

} // namespace trembler
