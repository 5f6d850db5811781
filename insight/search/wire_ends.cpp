#include "insight/search/wire_ends.hpp"

#include "physics/electricity/properties/electrical.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace trembler::insight {
namespace {

bool joins(LevelConnection const& wire, std::string const& a, std::string const& b) {
    return (wire.a == a && wire.b == b) || (wire.a == b && wire.b == a);
}

} // namespace

bool addRandomWire(LevelUnderTest const& level, Solution& solution, CounterRandom& random) {
    constexpr int tries = 16;
    auto const* const conductors = level.world().store().findColumn<Conductor>();
    if (conductors == nullptr || conductors->size() < 2 ||
        static_cast<int>(solution.wires.size()) >= level.level().wires) {
        return false;
    }
    auto const owners = conductors->owners();
    for (int n = 0; n < tries; ++n) {
        std::string const a = level.world().store().nameOf(owners[random.below(owners.size())]);
        std::string const b = level.world().store().nameOf(owners[random.below(owners.size())]);
        auto const same = [&](LevelConnection const& wire) { return joins(wire, a, b); };
        if (a != b &&
            std::none_of(level.level().connections.begin(), level.level().connections.end(), same) &&
            std::none_of(solution.wires.begin(), solution.wires.end(), same)) {
            solution.wires.push_back({std::min(a, b), std::max(a, b), "", {}});
            return true;
        }
    }
    return false;
}

void addRandomWires(LevelUnderTest const& level, Solution& solution, CounterRandom& random) {
    auto const* const conductors = level.world().store().findColumn<Conductor>();
    // Without a limit: as many as one for each conductor, which connect all of them.
    int const most = level.level().wires != unlimitedCount ? level.level().wires
                     : conductors == nullptr               ? 0
                                                           : static_cast<int>(conductors->size());
    for (int n = 0; n < most; ++n) {
        if (random.chance(0.5) && !addRandomWire(level, solution, random)) {
            return;
        }
    }
}

} // namespace trembler::insight
