// A completion reads a property that it does not declare.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Warmth final : Warming, Completion<Warmth, Reads<>, Adds<Heat>> {
    static void complete(Access& access) {
        access.add(Heat{300});
#ifndef TREMBLER_CONTROL
        access.add(Heat{access.find<Colour>()->hue});
#endif
    }
};

void add(Registry& registry) {
    registry.completion<Warmth>();
}

} // namespace trembler
