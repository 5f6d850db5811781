// An observer of a session's world tries to change it.
#include "puzzle/session/session.hpp"
#include "runtime/input/input_resolver.hpp"

namespace trembler {

Subscription look(Session& session) {
#ifndef TREMBLER_CONTROL
    session.world().step();
#endif
    return session.world().want<Hand>();
}

} // namespace trembler
