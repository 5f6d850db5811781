// A resolver property that merges the news (events) of a frame's parts also declares that it is a state
// without events.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Flames : Sparks {
#ifndef TREMBLER_CONTROL
    static constexpr std::string_view standing = "what burns";
#endif
};

struct Stove final : Resolver<Stove, HeatRole, Reads<Colour>, Writes<Heat>, Provides<Flames>> {
    static constexpr ComponentText text{.name = "Stove", .effect = "heat", .level = "", .work = "Heats."};
    using Activation = NeedsAny<Heat>;
    void advance(Access&) {}
};

void add(Registry& registry) {
    registry.component<Stove>();
}

} // namespace trembler
