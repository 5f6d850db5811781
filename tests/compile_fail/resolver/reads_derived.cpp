// A resolver declares to read a derived property: data of others reaches it by calls only.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Wish = Reads<Colour>;
#else
using Wish = Reads<Colour, Glow>;
#endif
struct Stove final : Resolver<Stove, HeatRole, Wish, Writes<Heat>> {
    static constexpr ComponentText text{.name = "Stove", .effect = "heat", .level = "", .work = "Heats."};
    using CalledFor = NeedsAny<Heat>;
    void advance(Access&) {}
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Stove>();

} // namespace trembler
