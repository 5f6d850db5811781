#include "physics/magnetism/magnetic_forces.hpp"

#include "physics/dynamics/mass_properties.hpp"
#include "runtime/property/for_each.hpp"

#include <algorithm>

namespace trembler {

Vec2 poleForce(Vec2 r, double q1, double q2) {
    double const d2 = lengthSquared(r) + magneticSoftening * magneticSoftening;
    return (-magneticConstant * q1 * q2 / (d2 * std::sqrt(d2))) * r;
}

// Shapes hardly ever change, and their centres of mass take a while to compute: once will do.
void MagneticForces::findCentres(Access& access) {
    auto const& strengths = access.read<MagneticStrength>();
    auto const& shapes = access.read<Shape>();
    std::uint64_t const version = shapes.version() + strengths.structureVersion();
    if (version == centresVersion_) {
        return;
    }
    centresVersion_ = version;
    centres_.assign(strengths.size(), {});
    for (std::size_t row = 0; row < strengths.size(); ++row) {
        if (Shape const* const shape = shapes.find(strengths.owners()[row])) {
            centres_[row] = centreOfMass(*shape);
        }
    }
}

void MagneticForces::gather(Access& access) {
    findCentres(access);
    poles_.clear();
    soft_.clear();
    auto const& strengths = access.read<MagneticStrength>();
    auto const& rotations = access.read<Rotation>();
    auto const& poleSets = access.read<MagneticPoles>();
    auto const& magnets = access.read<Magnet>();
    forEach(
        [&](ObjectId id, MagneticStrength const& strength, Position const& position) {
            Rotation const* const rotation = rotations.find(id);
            double const angle = rotation == nullptr ? 0 : rotation->angle;
            if (strength.susceptibility > 0) {
                Vec2 const centre = centres_[strengths.row(id)];
                soft_.push_back({id, position.value + rotated(centre, angle), strength.susceptibility});
            }
            Magnet const* const magnet = magnets.find(id);
            MagneticPoles const* const poles = poleSets.find(id);
            if (magnet == nullptr || poles == nullptr || !(magnet->level * strength.strength > 0)) {
                return;
            }
            double const q = magnet->level * strength.strength;
            if (poles->poles == PoleSet::north || poles->poles == PoleSet::both) {
                poles_.push_back({id, position.value + rotated(poles->north, angle), q});
            }
            if (poles->poles == PoleSet::south || poles->poles == PoleSet::both) {
                poles_.push_back({id, position.value + rotated(poles->south, angle), -q});
            }
        },
        strengths, access.read<Position>());
}

void MagneticForces::update(Access& access) {
    gather(access);
    auto const& switching = access.read<MagnetSwitching>().byIndex;
    auto const causeOf = [&](ObjectId id) {
        return id.valid() && id.index < switching.size() ? switching[id.index] : EventId{};
    };
    auto& forces = access.derive<MagneticForce>().forces;
    forces.clear();
    if (poles_.empty()) {
        return;
    }
    forces.resize(poles_.size() + soft_.size());
    // Every receiver sums over all others by itself, so no bit depends on threads.
    constexpr std::size_t receivers = 32; // as each of them is a sum over all others
    auto const sumUp = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            bool const isPole = i < poles_.size();
            Pole const& self = isPole ? poles_[i] : soft_[i - poles_.size()];
            Vec2 total;
            double strongest = -1;
            ObjectId from;
            for (Pole const& pole : poles_) {
                if (pole.object != self.object) {
                    // A soft object is drawn to either pole: as if of the opposite sign.
                    double const own =
                        isPole ? self.strength : (pole.strength > 0 ? -self.strength : self.strength);
                    Vec2 const force = poleForce(pole.at - self.at, own, pole.strength);
                    total += force;
                    if (lengthSquared(force) > strongest) {
                        strongest = lengthSquared(force);
                        from = pole.object;
                    }
                }
            }
            if (isPole) { // the pull that it exerts acts back on it
                for (Pole const& soft : soft_) {
                    if (soft.object != self.object) {
                        double const sign = self.strength > 0 ? -1 : 1;
                        total += poleForce(soft.at - self.at, self.strength, sign * soft.strength);
                    }
                }
                from = from.valid() ? from : self.object;
            }
            forces[i] = {self.object, self.at, total, causeOf(from)};
        }
    };
    access.forRanges(forces.size(), sumUp, receivers);
    std::stable_sort(
        forces.begin(), forces.end(),
        [](MagneticForce::Entry const& a, MagneticForce::Entry const& b) { return a.object < b.object; });
}

} // namespace trembler
