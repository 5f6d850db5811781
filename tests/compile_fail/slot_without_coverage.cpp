// A resolver property does not declare how the state hash covers it.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Embers {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Embers", "embers", "What still glows."};
#ifdef TREMBLER_CONTROL
    static constexpr Coverage coverage = hashed;
#endif
    static constexpr std::string_view standing = "what still glows";
    std::vector<ObjectId> objects;
};

struct Stove final : Resolver<Stove, HeatRole, Reads<Colour>, Writes<Heat>, Provides<Embers>> {
    static constexpr ComponentText text{.name = "Stove", .effect = "heat", .level = "", .work = "Heats."};
    using Activation = NeedsAny<Heat>;
    void advance(Access&) {}
};

void add(Registry& registry) {
    registry.component<Stove>();
}

} // namespace trembler
