// A completion declares to add a property that belongs to a resolver.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

template <class P>
concept CanBeAdded = requires {
    typename Adds<P>;
};
#ifdef TREMBLER_CONTROL
static_assert(CanBeAdded<Heat>, "a completion adds object properties only");
#else
static_assert(CanBeAdded<HotSpots>, "a completion adds object properties only");
#endif

} // namespace trembler
