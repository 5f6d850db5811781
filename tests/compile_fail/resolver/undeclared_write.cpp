// A resolver changes a property that it only declared to read.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Stove final : Resolver<Stove, HeatRole, Reads<Colour>, Writes<Heat>> {
    static constexpr ComponentText text{.name = "Stove", .effect = "heat", .level = "", .work = "Heats."};
    using Activation = NeedsAny<Heat>;
    void advance(Access& access) {
        access.write<Heat>().set(ObjectId{0, 0}, {300});
#ifndef TREMBLER_CONTROL
        access.write<Colour>().set(ObjectId{0, 0}, {});
#endif
    }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Stove>();

} // namespace trembler
