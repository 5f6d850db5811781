// A subscription is copied, so that it would be ended twice.
#include "runtime/input/input_resolver.hpp"
#include "runtime/world/world.hpp"

#include <utility>

namespace trembler {

Subscription keep(Subscription& given) {
#ifdef TREMBLER_CONTROL
    return std::move(given);
#else
    return given;
#endif
}

} // namespace trembler
