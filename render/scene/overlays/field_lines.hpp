// The lines of the magnetic field that the active poles of a world make together.
#pragma once

#include "physics/magnetism/properties.hpp"
#include "render/scene/facts/shape_geometry.hpp"
#include "runtime/world/world.hpp"

#include <span>
#include <vector>

namespace trembler::render {

struct FieldPole {
    Point at;            ///< m, in the world
    double strength = 0; ///< A m; north positive
};

/// Every pole that acts at present: those of permanent magnets and of electromagnets that are on or cooling
/// down.
[[nodiscard]] std::vector<FieldPole> activePoles(World const& world);

/// Direction and strength of the field, except for the factor µ0/4π: the sum of q r / (r² + s²)^(3/2), as for
/// magnetic forces.
[[nodiscard]] Point fieldAt(std::span<FieldPole const> poles, Point at, double softening = magneticSoftening);

struct FieldLineOptions {
    int linesPerPole = 16; ///< of the strongest pole; others get their share, at least 4
    double softening = magneticSoftening;
    double step = 0; ///< m, along the line; 0 picks it by the size of `within`
};

/// Lines from north poles to south poles (or to where they leave `within`), each in the direction of the
/// field. South poles that too few of these lines reach get lines of their own. Fourth-order Runge-Kutta
/// (Kutta 1901) in length along the line; the same input gives the same points. Empty without poles or for an
/// empty rectangle.
[[nodiscard]] std::vector<std::vector<Point>>
fieldLines(std::span<FieldPole const> poles, Extent const& within, FieldLineOptions const& options = {});

} // namespace trembler::render
