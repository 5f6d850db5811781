// The part of the Electricity resolver that carries out held calls.
#include "physics/electricity/core/electricity_resolver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler {

// The held calls on each source, added up in the order in which they are drained.
void ElectricityResolver::induceVoltages(Access& access) {
    auto const& emfs = access.read<Emf>();
    std::vector<double> sums(emfs.size(), 0);
    access.forCalls<AddVoltage>([&](AddVoltage const& call, CallOrigin const& /*origin*/) {
        std::uint32_t const row = emfs.row(call.object);
        if (row != ColumnBase::absent && std::isfinite(call.voltage)) {
            sums[row] += call.voltage;
        }
    });
    auto const was = emfs.values();
    if (!std::equal(sums.begin(), sums.end(), was.begin(), was.end(),
                    [](double sum, Emf const& emf) { return sum == emf.induced; })) {
        auto const now = access.write<Emf>().values();
        for (std::size_t r = 0; r < sums.size(); ++r) {
            now[r].induced = sums[r];
        }
    }
}

// A held connection is counted once, from the advance in which it is first held on. A connection that ended
// with an object, a fuse or a caller has the count zero, from which subtracting has no effect.
void ElectricityResolver::followHeld(Access& access) {
    std::vector<HeldConnections::Held> now;
    access.forCalls<HoldConnection>([&](HoldConnection const& call, CallOrigin const& origin) {
        if (call.a != call.b && conducts(access, call.a) && conducts(access, call.b)) {
            auto const [a, b] = std::minmax(call.a, call.b);
            now.push_back({a, b, origin.caller, origin.cause});
        }
    });
    if (now.empty() && held_.empty()) {
        return;
    }
    auto const& graph = access.read<ElectricityGraph>();
    for (HeldConnections::Difference const& difference : held_.replace(std::move(now))) {
        HeldConnections::Held const& held = difference.held;
        if (graph.has(held.a) && graph.has(held.b)) {
            changes_.push_back({held.a, held.b, held.caller, difference.delta, held.event});
        }
    }
}

} // namespace trembler
