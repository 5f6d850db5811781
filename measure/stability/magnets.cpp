// Magnets released in contact, with coinciding poles, and by the hundred.
#include "measure/stability/hard_case.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::stability {
namespace {

constexpr double mass = 0.5;
constexpr double wide = 0.2;
constexpr double high = 0.05;

// The pole strength (A m) at which two bars that lie side by side, like poles together, repel each other with
// `weights` times their weight: 2 µ0/4π q² r / (r² + s²)^(3/2), where r is their height.
double strengthFor(double weights) {
    double const perSquare =
        2 * 1e-7 * high / std::pow(high * high + magneticSoftening * magneticSoftening, 1.5);
    return std::sqrt(weights * mass * g / perSquare);
}

/// Bar magnets and their energies: kinetic, gravitational, and of every pair of poles.
class Magnets {
public:
    Magnets(Setting const& setting, std::uint64_t seed, double gravity)
        : rig(setting, seed, {0, -gravity}), gravity_(gravity) {}

    /// The poles lie on the bar's axis, at the distance `poles` from its middle.
    void bar(Vec2 at, double angle, double poles, double strength, bool collides = true) {
        ObjectId const id = rig.body(boxPiece(wide, high), at, mass, angle);
        rig.give(id, MagneticStrength{.strength = strength, .susceptibility = 0});
        rig.give(id, MagneticPoles{.poles = PoleSet::both, .north = {poles, 0}, .south = {-poles, 0}});
        if (!collides) {
            rig.give(id, CollisionGroups{.category = 1, .mask = 0xffff, .group = -1});
        }
        poles_.push_back({id, {poles, 0}, strength});
        poles_.push_back({id, {-poles, 0}, -strength});
    }

    [[nodiscard]] double energy() const { return kinetic() + potential().sum + height(); }
    /// Gravitational energy, J.
    [[nodiscard]] double height() const {
        double sum = 0;
        for (ObjectId const id : rig.bodies()) {
            sum += mass * gravity_ * rig.at(id).y;
        }
        return sum;
    }
    /// J.
    [[nodiscard]] double kinetic() const {
        double sum = 0;
        for (ObjectId const id : rig.bodies()) {
            AngularVelocity const* const spin = rig.world->find<AngularVelocity>(id);
            double const w = spin == nullptr ? 0 : spin->value;
            sum +=
                mass / 2 * lengthSquared(rig.velocity(id)) + mass * (wide * wide + high * high) / 24 * w * w;
        }
        return sum;
    }
    struct Potential {
        double sum = 0;  // J
        double size = 0; // J, sum of the absolute values
    };
    /// µ0/4π q1 q2 / √(r² + s²) for every two poles of different magnets.
    [[nodiscard]] Potential potential() const {
        Potential found;
        std::vector<Vec2> places;
        for (Pole const& pole : poles_) {
            places.push_back(rig.at(pole.of) + rotated(pole.at, rig.angle(pole.of)));
        }
        for (std::size_t i = 0; i < poles_.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (poles_[i].of != poles_[j].of) {
                    double const one = 1e-7 * poles_[i].strength * poles_[j].strength /
                                       std::hypot(length(places[i] - places[j]), magneticSoftening);
                    found.sum += one;
                    found.size += std::abs(one);
                }
            }
        }
        return found;
    }

    Rig rig;

private:
    struct Pole {
        ObjectId of;
        Vec2 at;
        double strength = 0; // A m; a south pole's is negative
    };
    std::vector<Pole> poles_;
    double gravity_;
};

// The greatest rise of the energy above its minimum so far, relative to the sum of all energies: between
// every two poles, and kinetic or gravitational.
std::vector<Figure> watch(Magnets& magnets, int frames) {
    double least = magnets.energy();
    double const height = magnets.height();
    double scale = 0;
    double growth = 0;
    for (int frame = 0; frame < frames && std::isfinite(growth); ++frame) {
        magnets.rig.step();
        double const now = orWorst(magnets.energy());
        scale = std::max(scale,
                         magnets.potential().size + std::max(magnets.kinetic(), height - magnets.height()));
        least = std::min(least, now);
        growth = std::max(growth, orWorst((now - least) / scale));
    }
    return {{"energy grows by", "%", 1, 100 * growth},
            {"not finite", "", 0, magnets.rig.finite() ? 0.0 : 1.0}};
}

// Two bars end to end, attracting; two bars side by side, repelling. The poles are 1 cm inside the ends.
std::vector<Figure> contact(Setting const& setting, std::uint64_t seed, double weights) {
    double const strength = strengthFor(weights);
    Magnets magnets(setting, seed, 0);
    double const jitter = 0.02 * magnets.rig.jitter();
    magnets.bar({0, 0}, 0, 0.09, strength);
    magnets.bar({wide, 0.01 * jitter}, jitter, 0.09, strength);
    magnets.bar({0, 3}, 0, 0.09, strength);
    magnets.bar({0.2 * jitter, 3 + high}, 0, 0.09, strength);
    return watch(magnets, 600);
}

// Poles at the very ends of touching bars: they coincide.
std::vector<Figure> polesMeet(Setting const& setting, std::uint64_t seed, double weights) {
    double const strength = strengthFor(weights);
    Magnets magnets(setting, seed, 0);
    double const jitter = 1e-3 * magnets.rig.jitter();
    magnets.bar({0, 0}, 0, wide / 2, strength);
    magnets.bar({wide, jitter}, 0, wide / 2, strength);
    magnets.bar({0, 3}, 0, wide / 2, strength);
    magnets.bar({wide, 3 + jitter}, pi, wide / 2, strength);
    return watch(magnets, 600);
}

// Two bars without collisions, one inside the other, attracting: they oscillate through each other for ever.
std::vector<Figure> oneInTheOther(Setting const& setting, std::uint64_t seed, double weights) {
    double const strength = strengthFor(weights);
    Magnets magnets(setting, seed, 0);
    double const jitter = 0.01 * (1 + 0.2 * magnets.rig.jitter());
    magnets.bar({0, 0}, 0, 0.09, strength, false);
    magnets.bar({jitter, 0}, pi, 0.09, strength, false);
    return watch(magnets, 600);
}

std::vector<Figure> heap(Setting const& setting, std::uint64_t seed, double weights) {
    double const strength = strengthFor(weights);
    Magnets magnets(setting, seed, g);
    Rig& rig = magnets.rig;
    rig.fixed(boxPiece(6, 0.4), {0, -0.2});
    rig.fixed(boxPiece(0.4, 8), {-1.2, 3.6});
    rig.fixed(boxPiece(0.4, 8), {1.2, 3.6});
    for (int i = 0; i < 100; ++i) {
        int const row = i / 5;
        magnets.bar({0.38 * (i % 5 - 2) + 0.02 * rig.jitter(), 0.2 + 0.24 * row}, 0.5 * rig.jitter(), 0.09,
                    strength);
    }
    return watch(magnets, 600);
}

} // namespace

std::vector<HardCase> magnetCases() {
    std::vector<HardCase> cases;
    using Make = std::vector<Figure> (*)(Setting const&, std::uint64_t, double);
    auto const add = [&](char const* row, Make make, bool quick) {
        for (double const weights : {0.1, 1.0, 10.0}) {
            cases.push_back(
                {row, fmt::format("{:g} times their weight", weights),
                 [=](Setting const& setting, std::uint64_t seed) { return make(setting, seed, weights); },
                 true, quick && weights < 5});
        }
    };
    add("magnets released at contact", contact, true);
    add("magnets released with poles at zero distance", polesMeet, true);
    add("magnets released one in the other, not colliding", oneInTheOther, true);
    add("100 magnets in a heap", heap, false);
    return cases;
}

} // namespace trembler::stability
