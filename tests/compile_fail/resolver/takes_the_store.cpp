// A resolver asks for the whole store without declaring that it writes everything.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Stove final : Resolver<Stove, HeatRole, Reads<Colour>, Writes<Heat>> {
    static constexpr ComponentText text{.name = "Stove", .effect = "heat", .level = "", .work = "Heats."};
#ifdef TREMBLER_CONTROL
    static constexpr bool writesEverything = true;
#else
    static constexpr bool writesEverything = false;
#endif
    using Activation = NeedsAny<Heat>;
    void bindStore(Store&) {}
    void advance(Access&) {}
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Stove>();

} // namespace trembler
