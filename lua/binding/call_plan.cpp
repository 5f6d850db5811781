#include "lua/binding/call_plan.hpp"

#include <algorithm>
#include <cstring>

namespace trembler::lua {

CallPlan planOf(CallDescription const& call) {
    CallPlan plan{.plain = true, .creates = call.text.name.starts_with("create"), .arguments = {}};
    for (FieldPlace const& place : call.arguments) {
        plan.plain = plan.plain && place.offset != FieldPlace::nowhere &&
                     (place.kind == FieldKind::boolean || place.kind == FieldKind::number ||
                      place.kind == FieldKind::vector || place.kind == FieldKind::object);
        plan.arguments.push_back({.kind = place.kind,
                                  .offset = place.offset,
                                  .minimum = place.info.minimum,
                                  .maximum = place.info.maximum,
                                  .minimumExcluded = place.info.minimumExcluded});
    }
    return plan;
}

CallGatherer::CallGatherer(RoleInfo const& role)
    : role_(role), bytes_(role.calls.size()), pending_(role.calls.size()) {}

char* CallGatherer::place(std::size_t call) {
    PendingCalls& pending = pending_[call];
    CallDescription const& description = role_.calls[call];
    if (pending.used == pending.room) {
        constexpr std::int32_t least = 64;
        pending.room = std::max(least, 2 * pending.room);
        bytes_[call].resize(static_cast<std::size_t>(pending.room) * description.size);
        pending.bytes = bytes_[call].data();
    }
    char* const at = pending.bytes + static_cast<std::size_t>(pending.used) * description.size;
    std::memcpy(at, description.initial.data(), description.size);
    return at;
}

void CallGatherer::record(OpenSource& source) {
    for (std::size_t call = 0; call < pending_.size(); ++call) {
        if (pending_[call].used != 0) {
            source.recordMany(call, pending_[call].bytes, static_cast<std::size_t>(pending_[call].used));
        }
    }
    drop();
}

void CallGatherer::drop() {
    for (PendingCalls& pending : pending_) {
        pending.used = 0;
    }
}

} // namespace trembler::lua
