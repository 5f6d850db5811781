// A class that imitates a completion but receives the whole store is rejected.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Warmth = WarmthAfter<Reads<>>;
#else
struct Warmth final {
    static CompletionInfo const& describeSelf() {
        static CompletionInfo const info{.type = typeid(Warmth),
                                         .text = Warming::text,
                                         .run = [](Store& store, std::span<ObjectId const> ids) {
                                             store.destroy({ids.begin(), ids.end()});
                                         }};
        return info;
    }
};
#endif

void add(Registry& registry) {
    registry.completion<Warmth>();
}

} // namespace trembler
