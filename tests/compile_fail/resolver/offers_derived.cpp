// A resolver offers a derived property as its own.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Offer = Provides<HotSpots>;
#else
using Offer = Derives<Glow>;
#endif
struct Stove final : Resolver<Stove, HeatRole, Reads<Colour>, Writes<Heat>, Offer> {
    static constexpr ComponentText text{.name = "Stove", .effect = "heat", .level = "", .work = "Heats."};
    using Activation = NeedsAny<Heat>;
    void advance(Access&) {}
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Stove>();

} // namespace trembler
