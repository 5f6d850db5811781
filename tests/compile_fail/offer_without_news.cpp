// A resolver property declares neither how the news (events) of a frame's parts are merged nor that it has no
// events. Its gather() lacks the span parameter, so it would never be called.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Flames {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Flames", "flames", "What has just begun to burn."};
    static constexpr Coverage coverage = hashed;
    std::vector<ObjectId> objects;

#ifdef TREMBLER_CONTROL
    static void gather(Flames& frame, Flames const& part, PartSpan);
#else
    static void gather(Flames& frame, Flames const& part);
#endif
};

struct Stove final : Resolver<Stove, HeatRole, Reads<Colour>, Writes<Heat>, Provides<HotSpots, Flames>> {
    static constexpr ComponentText text{.name = "Stove", .effect = "heat", .level = "", .work = "Heats."};
    using Activation = NeedsAny<Heat>;
    void advance(Access&) {}
};

void add(Registry& registry) {
    registry.component<Stove>();
}

} // namespace trembler
