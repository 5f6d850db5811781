// A resolver writes a resolver property that it does not offer.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Stove final
#ifdef TREMBLER_CONTROL
    : Resolver<Stove, HeatRole, Reads<>, Writes<Heat>, Provides<HotSpots>> {
#else
    : Resolver<Stove, HeatRole, Reads<>, Writes<Heat>> {
#endif
    static constexpr ComponentText text{.name = "Stove", .effect = "heat", .level = "", .work = "Heats."};
    using Activation = NeedsAny<Heat>;
    void advance(Access& access) {
        access.template provide<HotSpots>().objects.clear();
    }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Stove>();

} // namespace trembler
