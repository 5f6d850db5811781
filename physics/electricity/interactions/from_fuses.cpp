#include "physics/electricity/interactions/from_fuses.hpp"

#include "runtime/property/for_each.hpp"

#include <algorithm>
#include <map>

namespace trembler {

void ElectricityFromFuses::apply(Access& access) {
    auto const& quantities = access.read<ElectricalQuantities>();
    auto const overloaded = [&](ObjectId id, Fuse const& fuse) -> ElectricalQuantities::Entry const* {
        auto const* const entry = quantities.find(id);
        return !fuse.blown && entry != nullptr && entry->overload > 1 ? entry : nullptr;
    };
    std::map<ObjectId, double> worst; // by circuit
    forEach(
        [&](ObjectId id, Fuse const& fuse) {
            if (auto const* const entry = overloaded(id, fuse)) {
                double& most = worst[entry->circuit];
                most = std::max(most, entry->overload);
            }
        },
        access.read<Fuse>());
    if (worst.empty()) {
        return;
    }
    forEach(
        [&](ObjectId id, Fuse const& fuse) {
            auto const* const entry = overloaded(id, fuse);
            if (entry != nullptr && entry->overload >= (1 - equality) * worst[entry->circuit]) {
                access.call(BlowFuse{id}, entry->event);
            }
        },
        access.read<Fuse>());
}

} // namespace trembler
