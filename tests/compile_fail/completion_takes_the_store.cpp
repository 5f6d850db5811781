// A completion is a plain function with the whole store in its hands.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Warmth final : Completion<Warmth, Reads<>, Adds<Heat>> {
    static constexpr CompletionText text{.name = "Warmth", .work = "Warms."};
    using CalledFor = NeedsAll<Colour>;
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
template void Registry::completion<Warmth>();

} // namespace trembler
