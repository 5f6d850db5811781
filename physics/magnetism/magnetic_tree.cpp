#include "physics/magnetism/magnetic_tree.hpp"

#include "runtime/world/store.hpp"

namespace trembler {

bool MagneticTree::suits(Store const& store) {
    auto const* const poles = store.findColumn<MagneticPoles>();
    return poles != nullptr && poles->size() >= worthwhile;
}

void MagneticTree::sum(Access& access, MagneticSum sum, inverse_square::Points const& sources,
                       inverse_square::Points const& receivers, MagneticTotals totals) {
    auto const& all = access.read<MagnetismSettings>();
    double const angle = (all.empty() ? MagnetismSettings{} : all.values().front()).openingAngle;
    inverse_square::Tree& tree = trees_[static_cast<std::size_t>(sum)];
    tree.build(sources);
    tree.setReceivers(receivers, true);
    access.forRanges(receivers.size(), [&](std::size_t begin, std::size_t end) {
        tree.add(begin, end, angle, magneticSoftening * magneticSoftening, totals.forces, totals.stiffness);
    });
}

} // namespace trembler
