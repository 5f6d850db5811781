// A completion is a plain function that receives the whole store.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Warmth final : Warming, Completion<Warmth, Reads<>, Adds<Heat>> {
#ifdef TREMBLER_CONTROL
    static void complete(Access& access) {
        access.add(Heat{});
    }
#else
    static void complete(Store& store, ObjectId id) {
        store.column<Colour>().set(id, {});
    }
#endif
};

void add(Registry& registry) {
    registry.completion<Warmth>();
}

} // namespace trembler
