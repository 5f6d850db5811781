#include "physics/gravity/real_gravity.hpp"

#include "physics/inverse_square/kernels.hpp"

namespace trembler {

void RealGravity::update(Access& access) {
    GravityLaw const law = access.read<GravityLaw>().values().front();
    auto& forces = access.derive<GravityForce>();
    gatherMasses(access.read<Mass>(), access.read<Position>(), forces, sources_);
    weighReceivers(sources_, receivers_);
    sums_.clear(sources_.size());
    // The sum at each object is computed separately: twice the work of computing each pair once, but the
    // order of additions, and so every bit, is the same on any number of threads.
    access.forRanges(sources_.size(), [&](std::size_t begin, std::size_t end) {
        inverse_square::addAllPairs(sources_, receivers_, begin, end, law.softening * law.softening,
                                    sums_.fields, sums_.stiffness);
    });
    weighFields(law, sources_, sums_, forces);
}

} // namespace trembler
