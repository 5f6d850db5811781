// Who only looks at a session's world changes it.
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
