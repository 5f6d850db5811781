// Magnets and irons as columns of properties, without a world.
#pragma once

#include "physics/magnetism/magnetic_points.hpp"

#include <cstdint>

namespace trembler::test {

struct MagneticThings {
    ObjectId thing(Vec2 at, double strength, double susceptibility, MagneticPoles const& poles) {
        ObjectId const id{count++, 0};
        positions.set(id, {at});
        strengths.set(id, {strength, susceptibility});
        if (poles.poles != PoleSet::none) {
            poleSets.set(id, poles);
            magnets.set(id, Magnet{});
        }
        return id;
    }
    [[nodiscard]] MagneticColumns columns() const {
        return {positions, rotations, velocities, spins, masses, shapes, poleSets, strengths, magnets};
    }

    Column<Position> positions;
    Column<Rotation> rotations;
    Column<Velocity> velocities;
    Column<AngularVelocity> spins;
    Column<Mass> masses;
    Column<Shape> shapes;
    Column<MagneticPoles> poleSets;
    Column<MagneticStrength> strengths;
    Column<Magnet> magnets;
    std::uint32_t count = 0;
};

} // namespace trembler::test
