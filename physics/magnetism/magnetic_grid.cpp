#include "physics/magnetism/magnetic_grid.hpp"

#include <algorithm>

namespace trembler {

double magneticCutoff(MagnetismSettings const& settings, Column<MagneticStrength> const& strengths) {
    if (settings.cutoff > 0) {
        return settings.cutoff;
    }
    double pole = 0;
    double other = 0;
    for (MagneticStrength const& strength : strengths.values()) {
        pole = std::max(pole, strength.strength);
        other = std::max({other, strength.strength, strength.susceptibility});
    }
    // Without magnetic objects any length is correct.
    double const full = std::sqrt(magneticConstant * pole * other / settings.forceThreshold);
    return std::max(full, magneticSoftening) / fullShareOfCutoff;
}

bool MagneticGrid::faithful(Store const& store) {
    auto const* const all = store.findColumn<MagnetismSettings>();
    MagnetismSettings const settings =
        all == nullptr || all->empty() ? MagnetismSettings{} : all->values().front();
    return settings.cutoff > 0 ? settings.cutoff >= MagnetismSettings::leastCutoff
                               : settings.forceThreshold <= MagnetismSettings::greatestThreshold;
}

void MagneticGrid::sum(Access& access, MagneticSum sum, inverse_square::Points const& sources,
                       inverse_square::Points const& receivers, MagneticTotals totals) {
    auto const& all = access.read<MagnetismSettings>();
    double const cutoff = magneticCutoff(all.empty() ? MagnetismSettings{} : all.values().front(),
                                         access.read<MagneticStrength>());
    inverse_square::Grid& grid = grids_[static_cast<std::size_t>(sum)];
    grid.build(sources, cutoff);
    grid.setReceivers(receivers);
    access.forRanges(receivers.size(), [&](std::size_t begin, std::size_t end) {
        grid.add(begin, end, fullShareOfCutoff * cutoff, magneticSoftening * magneticSoftening, totals.forces,
                 totals.stiffness);
    });
}

} // namespace trembler
