// The common part of the detail levels of the magnetic forces: everything except the summation.
#pragma once

#include "physics/dynamics/properties/force_lag.hpp"
#include "physics/magnetism/magnetic_actions.hpp"
#include "physics/magnetism/magnetic_points.hpp"
#include "runtime/component/dps.hpp"

#include <cstdint>

namespace trembler {

namespace detail {
template <class Self, class... More>
using MagneticBase =
    Dps<Self,
        Reads<Position, Rotation, Velocity, AngularVelocity, Mass, Shape, MagneticPoles, MagneticStrength,
              Magnet, MagnetSwitching, ForceLag, MagnetismSettings, More...>,
        Derives<MagneticForce>>;
} // namespace detail

/// `Self` adds `text` and void sum(Access&, MagneticSum, sources, receivers, totals) which adds the
/// contributions of the sources at each receiver to `totals`, see inverse_square::Points. `More` are further
/// properties that it reads. It is absent without Dynamics, which provides the lag of forces: without it
/// forces have no effect.
template <class Self, class... More>
class MagneticLevel : public detail::MagneticBase<Self, More...> {
public:
    using Access = typename detail::MagneticBase<Self, More...>::Access;
    using Activation = NeedsAll<Magnet, MagneticStrength, Position>;
    static constexpr int longestPeriod =
        4; // held for longer, the force is no longer an approximation of the same physics
    static constexpr Coverage memory = leftOut("refilled in each update, or for traces only");

    void update(Access& access) {
        auto const& settings = access.template read<MagnetismSettings>();
        bool const ahead = settings.empty() || settings.values().front().lookAhead;
        double const lag = ahead ? access.template read<ForceLag>().ofTurn() : 0;
        MagneticColumns const columns{
            access.template read<Position>(),      access.template read<Rotation>(),
            access.template read<Velocity>(),      access.template read<AngularVelocity>(),
            access.template read<Mass>(),          access.template read<Shape>(),
            access.template read<MagneticPoles>(), access.template read<MagneticStrength>(),
            access.template read<Magnet>()};
        points_.gather(columns, lag);
        if (points_.active()) {
            for (MagneticSum const sum :
                 {MagneticSum::polesOnPoles, MagneticSum::softOnPoles, MagneticSum::polesOnSoft}) {
                if (!points_.sources(sum).empty() && !points_.receivers(sum).empty()) {
                    static_cast<Self&>(*this).sum(access, sum, points_.sources(sum), points_.receivers(sum),
                                                  points_.totals(sum));
                }
            }
        }
        auto& into = access.template derive<MagneticForce>();
        points_.exportForces(into);
        into.foreseen = ahead;
        if (access.tracing()) [[unlikely]] {
            bool const switched = columns.magnets.version() != magnets_;
            if (switched || (++sinceFollowed_ >= followPeriod && actions_.outdated(points_))) {
                sinceFollowed_ = 0;
                magnets_ = columns.magnets.version();
                actions_.follow(
                    points_, columns, access.template read<MagnetSwitching>().byIndex,
                    [&](std::string_view what, std::span<ObjectId const> objects,
                        std::span<EventId const> causes) { return access.event(what, objects, causes); },
                    into);
            }
            actions_.nameCauses(into);
        }
    }

private:
    MagneticPoints points_;
    MagneticActions actions_;          // while tracing
    std::uint64_t magnets_ = 0;        // version of the column when actions were followed last
    int sinceFollowed_ = followPeriod; // updates
};

} // namespace trembler
