// Somebody subscribes to a property of objects, which needs no reader to be there.
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
