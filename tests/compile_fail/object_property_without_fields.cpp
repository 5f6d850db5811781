// An object property that levels may state has a member that it does not describe, so that no level could
// state it.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Fuel {
    static constexpr PropertyKind kind = PropertyKind::object;
#ifdef TREMBLER_CONTROL
    static constexpr PropertyText text{"Fuel", "fuel", "What is left to burn.", PropertyPlace::hidden};
#else
    static constexpr PropertyText text{"Fuel", "fuel", "What is left to burn."};
#endif
    double kilograms = 1;
};

void add(Registry& registry) {
    registry.property<Fuel>();
}

} // namespace trembler
