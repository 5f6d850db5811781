#include "insight/miss/current/current_miss.hpp"

#include "insight/miss/condition_miss.hpp"
#include "insight/miss/current/short_circuits.hpp"
#include "insight/miss/current/ways_of_current.hpp"
#include "insight/miss/obstacles.hpp"
#include "physics/electricity/analyses/nodal.hpp"
#include "physics/electricity/properties/quantities.hpp"
#include "physics/electricity/properties/ratings.hpp"

#include <algorithm>
#include <utility>

namespace trembler::insight {
namespace current_miss {
namespace {

/// The share that a closed circuit keeps as long as too little current flows.
constexpr double shareOfPower = 0.3;

Miss unmeasured(ConditionState const& state) {
    Miss made;
    made.by = 1;
    made.objects = state.subjects();
    return made;
}

} // namespace
} // namespace current_miss

Miss missOfOn(ConditionState const& state, World const& world, CircuitSight& circuits) {
    Miss best = current_miss::unmeasured(state);
    for (ObjectId const id : state.subjects()) {
        CircuitCut const& cut = circuits.cutAt(world, id);
        Miss miss;
        miss.objects = {id};
        miss.by = 1;
        if (!cut.gaps.empty()) {
            miss.lack = Lack::gap;
            miss.by = cut.width;
            miss.gaps = cut.gaps;
            miss.measure = current_miss::shareOfPower +
                           (1 - current_miss::shareOfPower) * cut.cost / (cut.cost + typicalDistance);
        } else if (cut.hopeless) {
            if (best.lack == Lack::change) { // a miss with a measure says more
                best.lack = Lack::source;
                best.objects = {id};
            }
        } else {
            RatedPower const* const rated = world.find<RatedPower>(id);
            auto const* const quantities = world.find<ElectricalQuantities>();
            auto const* const entry = quantities == nullptr ? nullptr : quantities->find(id);
            if (rated != nullptr && entry != nullptr && rated->power > 0) {
                double const needed = NodalElectricity::leastPower * rated->power;
                miss.lack = Lack::power;
                miss.by = std::max(0.0, needed - entry->power);
                miss.measure = current_miss::shareOfPower * std::clamp(miss.by / needed, 0.0, 1.0);
            } else {
                miss.measure = current_miss::shareOfPower;
            }
            if (ObjectId const source = shortCircuitBeside(world, id); source.valid()) {
                miss.lack = Lack::shorted;
                miss.by = 1;
                miss.objects.push_back(source);
            }
        }
        if (miss.measure < best.measure) {
            best = miss;
        }
    }
    addSleepingCoils(best, world, circuits);
    return best;
}

Miss missOfOff(ConditionState const& state, World const& world) {
    Miss best = current_miss::unmeasured(state);
    for (ObjectId const id : state.subjects()) {
        std::vector<CurrentWay> ways = waysOfCurrent(world, id);
        auto const number = static_cast<double>(ways.size());
        double const measure = number / (number + 1);
        if (!ways.empty() && measure < best.measure) {
            best.lack = Lack::ways;
            best.ways = std::move(ways);
            best.by = number;
            best.measure = measure;
            best.objects = {id};
        }
    }
    return best;
}

} // namespace trembler::insight
