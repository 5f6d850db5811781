// A resolver declares to read a derived property: data of other components must come by calls only.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Request = Reads<Colour>;
#else
using Request = Reads<Colour, Glow>;
#endif
struct Stove final : Resolver<Stove, HeatRole, Request, Writes<Heat>> {
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
