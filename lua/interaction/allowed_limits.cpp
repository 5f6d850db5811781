#include "lua/interaction/allowed_limits.hpp"

#include <mutex>

namespace trembler::lua {
namespace {

struct Allowed {
    std::mutex mutex;
    ScriptLimits limits = ScriptLimits::greatest();
};
Allowed& allowed() {
    static Allowed instance;
    return instance;
}

} // namespace

ScriptLimits allowedLimits() {
    std::lock_guard const lock(allowed().mutex);
    return allowed().limits;
}
void allowLimits(ScriptLimits const& limits) {
    std::lock_guard const lock(allowed().mutex);
    allowed().limits = limits;
}

} // namespace trembler::lua
