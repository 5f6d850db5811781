#include "insight/run/dips_left_out.hpp"

#include "physics/buoyancy/properties/spared_by.hpp"

#include <algorithm>

namespace trembler::insight {

void leaveOutDips(World& world, std::span<Dip const> without) {
    if (without.empty()) {
        return;
    }
    auto& column = world.store().column<SparedBy>();
    for (auto const& [object, liquid] : without) {
        SparedBy const* const before = column.find(object);
        SparedBy spared = before == nullptr ? SparedBy{} : *before;
        if (!spared.has(liquid)) {
            spared.liquids.insert(std::upper_bound(spared.liquids.begin(), spared.liquids.end(), liquid),
                                  liquid);
            column.set(object, std::move(spared));
        }
    }
}

} // namespace trembler::insight
