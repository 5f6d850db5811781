// What the detail levels of the magnetic forces have in common: everything but the way of adding up.
#pragma once

#include "physics/dynamics/settings.hpp"
#include "physics/magnetism/magnetic_points.hpp"
#include "runtime/component/dps.hpp"

#include <algorithm>

namespace trembler {

/// `Self` adds `text` and
///     void sum(Access&, MagneticSum, sources, receivers, totals)
/// which adds to `totals` what the sources do to each receiver, see inverse_square::Points. `More` are
/// properties that it reads besides.
template <class Self, class... More>
class MagneticLevel
    : public Dps<Self,
                 Reads<Position, Rotation, Velocity, AngularVelocity, Shape, MagneticPoles, MagneticStrength,
                       Magnet, MagnetSwitching, DynamicsSettings, MagnetismSettings, More...>,
                 Derives<MagneticForce>> {
    using Base =
        Dps<Self,
            Reads<Position, Rotation, Velocity, AngularVelocity, Shape, MagneticPoles, MagneticStrength,
                  Magnet, MagnetSwitching, DynamicsSettings, MagnetismSettings, More...>,
            Derives<MagneticForce>>;

public:
    using Access = typename Base::Access;
    using CalledFor = NeedsAll<Magnet, MagneticStrength, Position>;

    void update(Access& access) {
        auto const& solver = access.template read<DynamicsSettings>();
        auto const& settings = access.template read<MagnetismSettings>();
        bool const ahead = settings.empty() || settings.values().front().lookAhead;
        double const lag = ahead ? frameDuration / 2 * (1 - 1.0 / ordinarySubsteps(solver)) : 0;
        points_.gather({access.template read<Position>(), access.template read<Rotation>(),
                        access.template read<Velocity>(), access.template read<AngularVelocity>(),
                        access.template read<Shape>(), access.template read<MagneticPoles>(),
                        access.template read<MagneticStrength>(), access.template read<Magnet>()},
                       lag);
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
    // As stated, or as many as an ordinary scene gets. It does without Dynamics, so it cannot ask that; where
    // there are in fact more, what is left of the lag is at most an eighth of a frame.
    static int ordinarySubsteps(Column<DynamicsSettings> const& settings) {
        int const stated =
            settings.empty() ? DynamicsSettings::automatic : settings.values().front().substeps;
        return stated == DynamicsSettings::automatic ? 4 : std::max(stated, 1);
    }

    MagneticPoints points_;
};

} // namespace trembler
