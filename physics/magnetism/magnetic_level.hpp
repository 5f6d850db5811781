// What the detail levels of the magnetic forces have in common: everything but the way of adding up.
#pragma once

#include "physics/magnetism/magnetic_points.hpp"
#include "runtime/component/dps.hpp"

namespace trembler {

/// `Self` adds `text` and
///     void sum(Access&, MagneticSum, sources, receivers, totals)
/// which adds to `totals` what the sources do to each receiver, see inverse_square::Points. `More` are
/// properties that it reads besides.
template <class Self, class... More>
class MagneticLevel
    : public Dps<
          Self,
          Reads<Position, Rotation, Shape, MagneticPoles, MagneticStrength, Magnet, MagnetSwitching, More...>,
          Derives<MagneticForce>> {
    using Base = Dps<
        Self,
        Reads<Position, Rotation, Shape, MagneticPoles, MagneticStrength, Magnet, MagnetSwitching, More...>,
        Derives<MagneticForce>>;

public:
    using Access = typename Base::Access;
    using CalledFor = NeedsAll<Magnet, MagneticStrength, Position>;

    void update(Access& access) {
        points_.gather({access.template read<Position>(), access.template read<Rotation>(),
                        access.template read<Shape>(), access.template read<MagneticPoles>(),
                        access.template read<MagneticStrength>(), access.template read<Magnet>()});
        if (points_.active()) {
            for (MagneticSum const sum :
                 {MagneticSum::polesOnPoles, MagneticSum::softOnPoles, MagneticSum::polesOnSoft}) {
                if (!points_.sources(sum).empty() && !points_.receivers(sum).empty()) {
                    static_cast<Self&>(*this).sum(access, sum, points_.sources(sum), points_.receivers(sum),
                                                  points_.totals(sum));
                }
            }
        }
        points_.exportForces(access.template read<MagnetSwitching>().byIndex,
                             access.template derive<MagneticForce>());
    }

private:
    MagneticPoints points_;
};

} // namespace trembler
