// A class that only looks like a completion, and runs with the whole store, is not taken for one.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
struct Warmth final : Completion<Warmth, Reads<>, Adds<Heat>> {
    static constexpr CompletionText text{.name = "Warmth", .work = "Warms."};
    using CalledFor = NeedsAll<Colour>;
    static void complete(Access& access) { access.add(Heat{}); }
};
#else
struct Warmth final {
    static CompletionInfo const& describeSelf() {
        static CompletionInfo const info{.type = typeid(Warmth),
                                         .text = {.name = "Warmth", .work = "Warms."},
                                         .run = [](Store& store, std::span<ObjectId const> ids) {
                                             store.destroy({ids.begin(), ids.end()});
                                         }};
        return info;
    }
};
#endif
template void Registry::completion<Warmth>();

} // namespace trembler
