#include "physics/gravity/tree_gravity.hpp"

#include "runtime/world/store.hpp"

namespace trembler {

bool TreeGravity::suits(Store const& store) {
    auto const* const masses = store.findColumn<Mass>();
    return masses != nullptr && masses->size() >= worthwhile;
}

void TreeGravity::update(Access& access) {
    GravityLaw const law = access.read<GravityLaw>().values().front();
    auto& forces = access.derive<GravityForce>();
    gatherMasses(access.read<Mass>(), access.read<Position>(), forces, sources_);
    weighReceivers(sources_, receivers_);
    sums_.clear(sources_.size());
    tree_.build(sources_);
    tree_.setReceivers(receivers_, false);
    access.forRanges(sources_.size(), [&](std::size_t begin, std::size_t end) {
        tree_.add(begin, end, law.openingAngle, law.softening * law.softening, sums_.fields, sums_.stiffness);
    });
    weighFields(law, sources_, sums_, forces);
}

} // namespace trembler
