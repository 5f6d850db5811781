// A completion adds a property that it only declared to read.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Warmth final : Warming, Completion<Warmth, Reads<Colour>, Adds<Heat>> {
    static void complete(Access& access) {
        access.add(Heat{access.find<Colour>()->hue});
#ifndef TREMBLER_CONTROL
        access.add(Colour{});
#endif
    }
};

void add(Registry& registry) {
    registry.completion<Warmth>();
}

} // namespace trembler
