// A subscription to an object property, which exists without readers.
#include "runtime/input/input_resolver.hpp"
#include "runtime/world/world.hpp"

namespace trembler {

void look(World const& world) {
    Subscription const hand = world.want<Hand>();
#ifndef TREMBLER_CONTROL
    Subscription const places = world.want<Position>();
#endif
}

} // namespace trembler
