#include "audio/effect/core/contact_pulse.hpp"

#include "audio/effect/properties/decibel.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {

double roundnessOf(Shape const& shape) {
    double round = 0;
    for (ShapePiece const& piece : shape.pieces) {
        bool const isRound = piece.form == ShapeForm::circle || piece.form == ShapeForm::capsule;
        if (!isRound) {
            return 0;
        }
        round = std::max(round, piece.radius);
    }
    return round;
}

double contactTime(Material a, Material b, double roundnessA, double roundnessB, double mass, double speed) {
    constexpr double edge = 0.005;    // m
    constexpr double briefest = 2e-5; // s
    constexpr double longest = 0.05;  // s
    constexpr double slowest = 1e-3;  // m/s
    auto const softness = [](Material material) {
        AcousticMaterial const& m = acousticMaterial(material);
        return (1 - m.poissonRatio * m.poissonRatio) / m.youngsModulus;
    };
    double const modulus = 1 / (softness(a) + softness(b));
    double const curvature = (roundnessA > 0 ? 1 / roundnessA : 0) + (roundnessB > 0 ? 1 / roundnessB : 0);
    double const radius = curvature > 0 ? 1 / curvature : edge;
    double const time =
        2.87 * std::pow(mass * mass / (radius * modulus * modulus * std::max(speed, slowest)), 0.2);
    return std::clamp(time, briefest, longest);
}

double spectrumOf(double contact, double frequency) {
    double const x = 2 * frequency * contact;
    return 1 / std::sqrt(1 + x * x * x * x);
}

double clickPressure(double movedAir, double mass, double impulse, double contact) {
    double const jerk = 2 * pi * impulse / (mass * contact * contact);
    return airDensity * movedAir / (4 * pi * speedOfSound) * jerk;
}

} // namespace trembler
