// Code outside the world calls a resolver that does not accept calls from outside.
#include "runtime/world/world.hpp"
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct BellRole {
    static constexpr std::string_view name = "Bell";
    static constexpr std::string_view fedBy = "the visitor";
    using Calls = CallList<AddHeat>;
};

void visit(World& world) {
    world.feed<BellRole>(AddHeat{ObjectId{0, 0}, 1});
#ifndef TREMBLER_CONTROL
    world.feed<HeatRole>(AddHeat{ObjectId{0, 0}, 1});
#endif
}

} // namespace trembler
