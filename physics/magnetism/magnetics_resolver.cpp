#include "physics/magnetism/magnetics_resolver.hpp"

#include "runtime/property/for_each.hpp"

#include <algorithm>
#include <map>

namespace trembler {

void MagneticsResolver::advance(Access& access) {
    std::map<ObjectId, EventId> enabled;
    access.forCalls<EnableMagnet>(
        [&](EnableMagnet const& call, CallOrigin origin) { enabled.try_emplace(call.object, origin.cause); });
    std::map<ObjectId, EventId> disabled;
    access.forCalls<DisableMagnet>([&](DisableMagnet const& call, CallOrigin origin) {
        disabled.try_emplace(call.object, origin.cause);
    });
    double const frames = access.duration() / frameDuration;
    cooling_ = false;
    // Finds the changes first, so that a frame without changes does not change the column's version.
    struct Change {
        ObjectId object;
        Magnet magnet;
        EventId event;
    };
    std::vector<Change> changes;
    forEach(
        [&](ObjectId id, Electromagnet const& coil, Magnet const& magnet) {
            auto const call = enabled.find(id);
            if (call != enabled.end()) {
                if (!magnet.on || magnet.level != 1) {
                    EventId const event =
                        magnet.on ? EventId{} : access.event("magnet on", {id}, {call->second});
                    changes.push_back({id, {true, 1}, event});
                }
                return;
            }
            if (magnet.on || magnet.level > 0) {
                auto const reason = disabled.find(id);
                EventId const cause = reason == disabled.end() ? EventId{} : reason->second;
                EventId const event = magnet.on ? access.event("magnet off", {id}, {cause}) : EventId{};
                // Less than half a step counts as zero, as rounding must not add a frame.
                double const step = frames / coil.coolDown;
                double const level = magnet.level - step < step / 2 ? 0 : magnet.level - step;
                changes.push_back({id, {false, level}, event});
                cooling_ = cooling_ || level > 0;
            }
        },
        access.read<Electromagnet>(), access.read<Magnet>());
    if (changes.empty()) {
        return;
    }
    auto& magnets = access.write<Magnet>();
    for (Change const& change : changes) {
        magnets[change.object] = change.magnet;
        if (change.event) {
            auto& events = access.provide<MagnetSwitching>().byIndex;
            events.resize(std::max<std::size_t>(events.size(), change.object.index + std::size_t{1}));
            events[change.object.index] = change.event;
        }
    }
}

} // namespace trembler
