// The Buoyancy resolver of 6.13.2, for any detail level.
#pragma once

#include "physics/buoyancy/calls.hpp"
#include "physics/buoyancy/core/flotation.hpp"
#include "runtime/component/resolver.hpp"

#include <array>

namespace trembler {

/// `Self` adds `text` and `prepare(access)`, which returns a Flotation::HullMaker. It reads the properties
/// that 6.13.2 lists; Air and InAir, as air is a fluid, too; Fixed, as fixed objects need no buoyancy;
/// SparedBy; and `More`, the properties that its detail level needs.
///
/// It is independent of collisions and does not lag behind them: bodies displace liquid where they are in
/// this frame (6.12.4). Gravity comes from the calls that it receives. The pressure in a liquid grows in the
/// direction of gravity, whichever way its surface is tilted.
template <class Self, ObjectProperty... More>
class BuoyancyResolver
    : public Resolver<Self, BuoyancyRole,
                      Reads<Position, Rotation, Shape, Density, Liquid, Air, InAir, Fixed, SparedBy, More...>,
                      Writes<>, Provides<LinearGravityVector, BuoyancyForce, CentreOfBuoyancy, Immersions>> {
    using Base =
        Resolver<Self, BuoyancyRole,
                 Reads<Position, Rotation, Shape, Density, Liquid, Air, InAir, Fixed, SparedBy, More...>,
                 Writes<>, Provides<LinearGravityVector, BuoyancyForce, CentreOfBuoyancy, Immersions>>;

public:
    using Activation = NeedsAny<Liquid, Air, InAir>;
    static constexpr int longestPeriod = 12; // docs/buoyancy.md: no visible errors up to this period
    static constexpr Coverage memory = leftOut("hulls, computed from shapes, and which of them moved");
    using Access = typename Base::Access;

    void advance(Access& access) {
        Vec2 const gravity = gravityNow(access);
        bool const otherGravity = !(gravity == access.template provided<LinearGravityVector>().gravity);
        if (otherGravity) {
            access.template provide<LinearGravityVector>().gravity = gravity;
        }
        FlotationColumns const columns{access.template read<Position>(), access.template read<Rotation>(),
                                       access.template read<Shape>(),    access.template read<Density>(),
                                       access.template read<Liquid>(),   access.template read<Air>(),
                                       access.template read<InAir>(),    access.template read<Fixed>(),
                                       access.template read<SparedBy>()};
        Flotation::HullMaker const makeHull = static_cast<Self&>(*this).prepare(access, flotation_);
        bool const moved = flotation_.follow(
            columns, makeHull, [&](std::size_t count, auto const& f) { access.forRanges(count, f, hulls); });
        if (moved || otherGravity) {
            publish(access, columns, gravity);
        }
    }

private:
    static constexpr std::size_t hulls = 32; // per range: each is a polygon to be clipped, or many particles

    static Vec2 gravityNow(Access const& access) {
        Vec2 sum;
        access.template forCalls<SetLinearGravity>([&](SetLinearGravity const& call, CallOrigin const&) {
            sum += isFinite(call.gravity) ? call.gravity : Vec2{};
        });
        return sum;
    }
    void publish(Access& access, FlotationColumns const& columns, Vec2 gravity) {
        flotation_.gather(next_, gravity);
        Immersions& immersions = access.template provide<Immersions>();
        if (access.tracing()) {
            matchEvents(
                immersions.entries, next_,
                [&](Immersions::Entry const& entry) {
                    return entry.liquid.valid()
                               ? access.event("enters the liquid", {entry.object, entry.liquid}, {})
                               : access.event("enters the air", {entry.object}, {});
                },
                [&](Immersions::Entry const& entry) {
                    if (entry.liquid.valid()) {
                        access.event("leaves the liquid", {entry.object, entry.liquid}, {entry.event});
                    } else {
                        access.event("leaves the air", {entry.object}, {entry.event});
                    }
                });
        }
        std::swap(immersions.entries, next_);
        immersions.interval = access.duration();
        sumForces(
            immersions.entries, gravity,
            [&](ObjectId id) {
                Rotation const* const rotation = columns.rotation.find(id);
                return Pose(columns.position[id].value, rotation == nullptr ? 0 : rotation->angle);
            },
            access.template provide<BuoyancyForce>(), access.template provide<CentreOfBuoyancy>());
    }

    Flotation flotation_;
    std::vector<Immersions::Entry> next_; // a member to reuse its memory
};

} // namespace trembler
