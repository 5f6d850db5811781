// Two bodies under real gravity: ten thousand revolutions, and close encounters with little time for the
// turn.
#include "measure/stability/hard_case.hpp"
#include "physics/gravity/properties.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::stability {
namespace {

constexpr double softening = 1e-3; // m

struct Pair {
    Rig rig;
    ObjectId star;
    ObjectId planet;
    double constant = 0; // N m²/kg²
    double starMass = 1000;
    double planetMass = 1;

    // `r` m apart, moving transversely at `speed` m/s relative to each other; the centre of mass rests.
    Pair(Setting const& setting, std::uint64_t seed, double law, Vec2 r, Vec2 speed)
        : rig(setting, seed, {}), constant(law) {
        double const share = planetMass / (starMass + planetMass);
        GravityLaw gravity;
        gravity.constant = constant;
        gravity.softening = softening;
        rig.give(rig.world->store().find("world"), gravity);
        star = rig.body(circlePiece(0.1), -share * r, starMass);
        planet = rig.body(circlePiece(0.05), (1 - share) * r, planetMass);
        rig.give(star, Velocity{-share * speed});
        rig.give(planet, Velocity{(1 - share) * speed});
    }
    /// J
    [[nodiscard]] double energy() const {
        double const r = length(rig.at(planet) - rig.at(star));
        return starMass / 2 * lengthSquared(rig.velocity(star)) +
               planetMass / 2 * lengthSquared(rig.velocity(planet)) -
               constant * starMass * planetMass / std::hypot(r, softening);
    }
};

// A revolution takes about 2 s. Drift is measured on the mean over a revolution, because the energy of a
// symplectic integrator oscillates within one.
std::vector<Figure> revolutions(Setting const& setting, std::uint64_t seed, int count) {
    constexpr double axis = 3;
    constexpr int framesEach = 120;
    double const period = framesEach / 60.0;
    Jitter jitter(seed);
    double const eccentricity = 0.2 + 0.1 * jitter();
    double const law = 4 * pi * pi * axis * axis * axis / (period * period * 1001);
    double const r = axis * (1 - eccentricity);
    Pair pair(setting, seed, law, {r, 0}, {0, std::sqrt(law * 1001 * (2 / r - 1 / axis))});
    double first = 0;
    double drift = 0;
    for (int i = 0; i < count; ++i) {
        double mean = 0;
        for (int frame = 0; frame < framesEach; ++frame) {
            pair.rig.step();
            mean += pair.energy() / framesEach;
        }
        first = i == 0 ? mean : first;
        drift = std::max(drift, orWorst(std::abs(mean / first - 1)));
    }
    return {{"energy drift", "%", 1, 100 * drift}};
}

// Approaches from 20 m on a hyperbola, is deflected by most of a circle, and leaves. At 20 m again, it must
// have its initial energy.
std::vector<Figure> encounter(Setting const& setting, std::uint64_t seed) {
    constexpr double law = 0.05;
    Jitter jitter(seed);
    double const past = 2 + 0.5 * jitter(); // m, impact parameter
    Pair pair(setting, seed, law, {-20, past}, {4, 0});
    double const before = pair.energy();
    double nearest = 20;
    for (int frame = 0; frame < 36000; ++frame) {
        pair.rig.step();
        double const r = length(pair.rig.at(pair.planet) - pair.rig.at(pair.star));
        nearest = std::min(nearest, orWorst(r));
        if (frame > 60 && !(r < 20)) {
            break;
        }
    }
    return {{"energy drift", "%", 1, 100 * orWorst(std::abs(pair.energy() / before - 1))},
            {"nearest", "m", std::numeric_limits<double>::infinity(), nearest}};
}

} // namespace

std::vector<HardCase> orbitCases() {
    return {{"real gravity", "10000 orbits",
             [](Setting const& setting, std::uint64_t seed) { return revolutions(setting, seed, 10000); },
             true, false},
            {"real gravity", "100 orbits",
             [](Setting const& setting, std::uint64_t seed) { return revolutions(setting, seed, 100); }},
            {"real gravity", "close encounter", encounter}};
}

} // namespace trembler::stability
