// The poles that act in a world and the objects that they attract, as points, with their sums turned into
// F_M. All detail levels of magnetism use it for input and output.
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"
#include "physics/inverse_square/points.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/column.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace trembler {

struct MagneticColumns {
    Column<Position> const& positions;
    Column<Rotation> const& rotations;
    Column<Velocity> const& velocities;
    Column<AngularVelocity> const& spins;
    Column<Mass> const& masses;
    Column<Shape> const& shapes;
    Column<MagneticPoles> const& poleSets;
    Column<MagneticStrength> const& strengths;
    Column<Magnet> const& magnets;
};

/// The kinds of sources and receivers. Each is one inverse-square sum.
enum class MagneticSum : std::size_t {
    polesOnPoles, ///< like poles repel
    softOnPoles,  ///< the reaction of a soft object on a pole
    polesOnSoft,  ///< a soft object is attracted by any pole, as if it had the opposite sign
};
inline constexpr std::size_t magneticSums = 3;

/// The sums at each receiver.
struct MagneticTotals {
    std::span<Vec2> forces;      ///< N
    std::span<double> stiffness; ///< N/m, see inverse_square::addAllPairs()
};

class MagneticPoints {
public:
    /// Forces are held for a frame. In an engine that integrates them in n substeps they lag by (1 - 1/n)/2
    /// of a frame, which makes the energy of oscillations grow. So points are placed where their objects will
    /// be after `lag` (s): for a body with magnetic forces only, drift, kick and drift then alternate, which
    /// is symplectic.
    void gather(MagneticColumns const& columns, double lag);

    /// Whether any pole acts.
    [[nodiscard]] bool active() const { return !poles_.empty(); }
    /// The receivers' weights include µ0/4π and all signs, so that the sum is the force in N.
    [[nodiscard]] inverse_square::Points const& sources(MagneticSum sum) const;
    [[nodiscard]] inverse_square::Points const& receivers(MagneticSum sum) const;
    /// The object of each source, and of each receiver; ascending.
    [[nodiscard]] std::span<ObjectId const> sourceObjects(MagneticSum sum) const;
    [[nodiscard]] std::span<ObjectId const> receiverObjects(MagneticSum sum) const;
    /// Calls f(object, poles, soft) for each object that has points, ascending, with the ranges of its poles
    /// and of its susceptible centre among the sources of polesOnPoles and of softOnPoles.
    template <class F>
    void forObjects(F&& f) const;
    /// The totals of a sum, in the order of the receivers. polesOnPoles and softOnPoles share one.
    [[nodiscard]] MagneticTotals totals(MagneticSum sum);

    /// Entries ascending by object, north before south, and how fast the forces on each object vary: a force
    /// on a pole, of stiffness k and at a distance a from the centre of mass, swings a body of mass m and
    /// moment of inertia I with ω² = k (1/m + a²/I); the sum over all poles of a body is at least the square
    /// of its fastest swing, and at most three times as much. Sets neither causes nor actions.
    void exportForces(MagneticForce& into) const;

private:
    void findSpreads(MagneticColumns const& columns);
    void exportRates(MagneticForce& into) const;
    void exportBrakes(MagneticForce& into) const;

    std::vector<MassProperties> spreads_; // by row of MagneticStrength
    std::uint64_t spreadsVersion_ = 0;    // of the columns that they were made from

    std::vector<ObjectId> poleObjects_; // ascending
    std::vector<ObjectId> softObjects_;
    std::vector<Vec2> poleShifts_; // m, from the body's place to its assumed place
    std::vector<Vec2> softShifts_;
    inverse_square::Points poles_;         // weight: strength in A m, north positive
    inverse_square::Points unsignedPoles_; // the same without signs
    inverse_square::Points soft_;          // weight: susceptibility in A m
    inverse_square::Points repelled_;      // the poles, as receivers of forces from poles
    inverse_square::Points pulledPoles_;   // the poles, as receivers of forces from soft objects
    inverse_square::Points pulledSoft_;
    std::vector<double> poleYields_; // 1/kg, 1/m + a²/I of each pole's body; 0 where it has no mass
    std::vector<double> softYields_;
    std::vector<double> softGyrations_; // m², the square of the radius of gyration
    std::vector<Vec2> onPoles_;         // N
    std::vector<Vec2> onSoft_;
    std::vector<double> poleStiffness_; // N/m
    std::vector<double> softStiffness_;
};

/// Consecutive points of one object.
struct PointRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};

template <class F>
void MagneticPoints::forObjects(F&& f) const {
    std::size_t pole = 0;
    std::size_t soft = 0;
    while (pole < poleObjects_.size() || soft < softObjects_.size()) {
        bool const both = pole < poleObjects_.size() && soft < softObjects_.size();
        ObjectId const id = both                         ? std::min(poleObjects_[pole], softObjects_[soft])
                            : pole < poleObjects_.size() ? poleObjects_[pole]
                                                         : softObjects_[soft];
        PointRange poles{pole, pole};
        for (; poles.end < poleObjects_.size() && poleObjects_[poles.end] == id; ++poles.end) {
        }
        PointRange centre{soft, soft};
        for (; centre.end < softObjects_.size() && softObjects_[centre.end] == id; ++centre.end) {
        }
        pole = poles.end;
        soft = centre.end;
        f(id, poles, centre);
    }
}

/// µ0/4π in N/A².
inline constexpr double magneticConstant = 1e-7;

/// Force (N) on a pole at distance vector `r` (m, from it to the other pole) with strengths q1, q2 (A m).
[[nodiscard]] Vec2 poleForce(Vec2 r, double q1, double q2);

} // namespace trembler
