// A resolver reads a property that is in neither its Reads<> nor its Writes<>.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Stove final : Resolver<Stove, HeatRole, Reads<>, Writes<Heat>> {
    static constexpr ComponentText text{.name = "Stove", .effect = "heat", .level = "", .work = "Heats."};
    using Activation = NeedsAny<Heat>;
    void advance(Access& access) {
        static_cast<void>(access.read<Heat>().size());
#ifndef TREMBLER_CONTROL
        static_cast<void>(access.read<Colour>().size());
#endif
    }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Stove>();

} // namespace trembler
