#include "physics/magnetism/magnetic_points.hpp"

#include "runtime/property/for_each.hpp"

#include <algorithm>

namespace trembler {

Vec2 poleForce(Vec2 r, double q1, double q2) {
    double const d2 = lengthSquared(r) + magneticSoftening * magneticSoftening;
    return (-magneticConstant * q1 * q2 / (d2 * std::sqrt(d2))) * r;
}

namespace {

// The farthest that an object is assumed to move, in m: obstacles on its path are not known, and beyond the
// magnet it would be pulled back.
constexpr double farthestShift = magneticSoftening / 2;

Vec2 shortened(Vec2 shift) {
    double const size = length(shift);
    return size > farthestShift ? farthestShift / size * shift : shift;
}

} // namespace

// Shapes rarely change, and their centres of mass are expensive to compute, so they are stored.
void MagneticPoints::findSpreads(MagneticColumns const& columns) {
    std::uint64_t const version = columns.shapes.version() + columns.strengths.structureVersion();
    if (version == spreadsVersion_) {
        return;
    }
    spreadsVersion_ = version;
    spreads_.assign(columns.strengths.size(), {});
    for (std::size_t row = 0; row < columns.strengths.size(); ++row) {
        if (Shape const* const shape = columns.shapes.find(columns.strengths.owners()[row])) {
            spreads_[row] = massPropertiesOf(*shape);
        }
    }
}

void MagneticPoints::gather(MagneticColumns const& columns, double lag) {
    findSpreads(columns);
    poleObjects_.clear();
    softObjects_.clear();
    poleShifts_.clear();
    softShifts_.clear();
    for (auto* const points : {&poles_, &unsignedPoles_, &soft_, &repelled_, &pulledPoles_, &pulledSoft_}) {
        points->clear();
    }
    poleYields_.clear();
    softYields_.clear();
    softGyrations_.clear();
    auto const addPole = [&](ObjectId id, Vec2 at, double q, Vec2 shift) {
        poleObjects_.push_back(id);
        poleShifts_.push_back(shift);
        poles_.add(at, q, id.index);
        unsignedPoles_.add(at, std::abs(q), id.index);
        repelled_.add(at, -magneticConstant * q, id.index);
        pulledPoles_.add(at, magneticConstant * std::abs(q), id.index);
    };
    forEach(
        [&](ObjectId id, MagneticStrength const& strength, Position const& position) {
            Rotation const* const rotation = columns.rotations.find(id);
            Velocity const* const velocity = columns.velocities.find(id);
            AngularVelocity const* const spin = columns.spins.find(id);
            double const now = rotation == nullptr ? 0 : rotation->angle;
            double const angle = spin == nullptr ? now : now + lag * spin->value;
            Vec2 const shift = velocity == nullptr ? Vec2{} : shortened(lag * velocity->value);
            // The centre of mass moves in a straight line; the origin follows from it.
            MassProperties const& spread = spreads_[columns.strengths.row(id)];
            Vec2 const centre = spread.centre;
            Mass const* const mass = columns.masses.find(id);
            double const yield = mass == nullptr ? 0 : 1 / mass->value;
            auto const yieldAt = [&](Vec2 point) {
                double const turning = spread.inertiaPerMass;
                return turning > 0 ? yield * (1 + lengthSquared(point - centre) / turning) : yield;
            };
            Vec2 const origin = position.value + shift + (rotated(centre, now) - rotated(centre, angle));
            if (strength.susceptibility > 0) {
                Vec2 const at = origin + rotated(centre, angle);
                softObjects_.push_back(id);
                softShifts_.push_back(shift);
                softYields_.push_back(yield);
                softGyrations_.push_back(spread.inertiaPerMass);
                soft_.add(at, strength.susceptibility, id.index);
                pulledSoft_.add(at, magneticConstant * strength.susceptibility, id.index);
            }
            Magnet const* const magnet = columns.magnets.find(id);
            MagneticPoles const* const poles = columns.poleSets.find(id);
            if (magnet == nullptr || poles == nullptr || !(magnet->level * strength.strength > 0)) {
                return;
            }
            double const q = magnet->level * strength.strength;
            if (poles->poles == PoleSet::north || poles->poles == PoleSet::both) {
                addPole(id, origin + rotated(poles->north, angle), q, shift);
                poleYields_.push_back(yieldAt(poles->north));
            }
            if (poles->poles == PoleSet::south || poles->poles == PoleSet::both) {
                addPole(id, origin + rotated(poles->south, angle), -q, shift);
                poleYields_.push_back(yieldAt(poles->south));
            }
        },
        columns.strengths, columns.positions);
    onPoles_.assign(poles_.size(), {});
    onSoft_.assign(soft_.size(), {});
    poleStiffness_.assign(poles_.size(), 0);
    softStiffness_.assign(soft_.size(), 0);
}

inverse_square::Points const& MagneticPoints::sources(MagneticSum sum) const {
    return sum == MagneticSum::polesOnPoles  ? poles_
           : sum == MagneticSum::softOnPoles ? soft_
                                             : unsignedPoles_;
}

inverse_square::Points const& MagneticPoints::receivers(MagneticSum sum) const {
    return sum == MagneticSum::polesOnPoles  ? repelled_
           : sum == MagneticSum::softOnPoles ? pulledPoles_
                                             : pulledSoft_;
}

MagneticTotals MagneticPoints::totals(MagneticSum sum) {
    return sum == MagneticSum::polesOnSoft ? MagneticTotals{onSoft_, softStiffness_}
                                           : MagneticTotals{onPoles_, poleStiffness_};
}

std::span<ObjectId const> MagneticPoints::sourceObjects(MagneticSum sum) const {
    return sum == MagneticSum::softOnPoles ? softObjects_ : poleObjects_;
}

std::span<ObjectId const> MagneticPoints::receiverObjects(MagneticSum sum) const {
    return sum == MagneticSum::polesOnSoft ? softObjects_ : poleObjects_;
}

void MagneticPoints::exportForces(MagneticForce& into) const {
    auto& forces = into.forces;
    forces.clear();
    into.rates.clear();
    into.brakes.clear();
    if (!active()) {
        return;
    }
    for (std::size_t i = 0; i < poleObjects_.size(); ++i) {
        forces.push_back({poleObjects_[i], poles_.at(i) - poleShifts_[i], onPoles_[i], {}});
    }
    for (std::size_t i = 0; i < softObjects_.size(); ++i) {
        forces.push_back({softObjects_[i], soft_.at(i) - softShifts_[i], onSoft_[i], {}});
    }
    std::inplace_merge(
        forces.begin(), forces.begin() + static_cast<std::ptrdiff_t>(poleObjects_.size()), forces.end(),
        [](MagneticForce::Entry const& a, MagneticForce::Entry const& b) { return a.object < b.object; });
    exportRates(into);
    exportBrakes(into);
}

void MagneticPoints::exportRates(MagneticForce& into) const {
    forObjects([&](ObjectId id, PointRange poles, PointRange soft) {
        double square = 0;
        for (std::size_t i = poles.begin; i < poles.end; ++i) {
            square += poleStiffness_[i] * poleYields_[i];
        }
        for (std::size_t i = soft.begin; i < soft.end; ++i) {
            square += softStiffness_[i] * softYields_[i];
        }
        if (square > 0) {
            into.rates.push_back({id, std::sqrt(square)});
        }
    });
}

void MagneticPoints::exportBrakes(MagneticForce& into) const {
    for (std::size_t soft = 0; soft < softObjects_.size(); ++soft) {
        double const angular = magneticLag * softStiffness_[soft] * softGyrations_[soft];
        if (softYields_[soft] > 0 && angular > 0) {
            into.brakes.push_back({softObjects_[soft], soft_.at(soft) - softShifts_[soft], angular});
        }
    }
}

} // namespace trembler
