#include "insight/miss/current/nearest_circuits.hpp"

#include "physics/magnetism/properties.hpp"

#include <utility>
#include <vector>

namespace trembler::insight {

void NearestCircuits::look(World const& world, CircuitSight& circuits) {
    auto const* const electromagnets = world.store().findColumn<Electromagnet>();
    if (electromagnets == nullptr) {
        return;
    }
    for (ObjectId const id : electromagnets->owners()) {
        CircuitCut const& cut = circuits.cutAt(world, id);
        if (cut.hopeless) {
            continue;
        }
        Coil& coil = coils_[id];
        if (cut.gaps.empty()) {
            coil.closed = world.frame();
        } else if (coil.best.gaps.empty() || cut.cost < coil.cost) {
            coil.cost = cut.cost;
            coil.best = {};
            coil.best.lack = Lack::gap;
            coil.best.by = cut.width;
            coil.best.frame = world.frame();
            coil.best.atBest = true;
            coil.best.objects = {id};
            coil.best.gaps = cut.gaps;
            nameObjects(coil.best, world.store());
        }
    }
}

void NearestCircuits::judge(Miss& miss, std::uint64_t frame) const {
    std::vector<Miss> judged;
    for (Miss& other : miss.besides) {
        bool const open = other.lack == Lack::gap || other.lack == Lack::source;
        auto const coil =
            open && other.objects.size() == 1 ? coils_.find(other.objects.front()) : coils_.end();
        if (coil == coils_.end()) {
            judged.push_back(std::move(other));
        } else if (coil->second.closed == 0) {
            judged.push_back(coil->second.best);
        } else if (coil->second.closed < frame) {
            judged.push_back(std::move(other));
        }
    }
    miss.besides = std::move(judged);
}

} // namespace trembler::insight
