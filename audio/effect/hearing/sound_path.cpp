#include "audio/effect/hearing/sound_path.hpp"

#include "audio/effect/properties/decibel.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

constexpr double nearest = 0.1;   // m
constexpr double thinnest = 0.01; // m: less of an obstacle than that on the line is no wall
constexpr double worthAWay =
    0.33; // of the energy: if more than that gets through, a way around hardly adds to it

} // namespace

// Both formulas are published in dB; as shares of energy they need no logarithm.

double shareThrough(double massPerArea, double frequency) {
    constexpr double lossless = 50118.72336272725; // 47 dB
    double const product = std::max(1e-9, massPerArea * frequency);
    return std::min(1.0, lossless / (product * product));
}

double shareAround(double detour, double frequency) {
    constexpr double most = 251.18864315095797; // 24 dB
    double const fresnel = 2 * std::max(0.0, detour) * frequency / speedOfSound;
    return 1 / std::min(most, 3 + 20 * fresnel);
}

double transmission(ObstacleField const& field, std::span<ObjectId const> exempt, Vec2 from, Vec2 to,
                    double frequency, PathDetail detail, double least, int patience) {
    double const distance = std::max(nearest, length(to - from));
    // Sound begins at the surface of the obstacle that its source is in; a built-in body is heard outside,
    // and shields it.
    auto const inTheWay = [&](Obstacle const& obstacle) {
        return std::find(exempt.begin(), exempt.end(), obstacle.object) == exempt.end() &&
               !contains(obstacle, from) && !contains(obstacle, to);
    };
    thread_local std::vector<std::uint32_t> onTheLine; // kept for its memory
    field.along(from, to, onTheLine);
    double through = 1;
    double eachAlone = 1;
    for (std::uint32_t const n : onTheLine) {
        Obstacle const& wall = field.all()[n];
        double const chord = chordOf(wall, from, to);
        if (chord < thinnest || !inTheWay(wall)) {
            continue;
        }
        double const share = shareThrough(wall.density * chord, frequency);
        through *= share;
        if (detail == PathDetail::straight) {
            double const detour = detourAround(wall, from, to) - length(to - from);
            eachAlone *= std::min(1.0, share + shareAround(detour, frequency));
            if (eachAlone < least * distance * distance) {
                return 0;
            }
        }
    }
    double const direct = through / (distance * distance);
    if (detail == PathDetail::straight) {
        return eachAlone / (distance * distance);
    }
    if (through > worthAWay) {
        return direct;
    }
    std::vector<Obstacle const*> walls;
    for (Obstacle const& obstacle : field.all()) {
        if (inTheWay(obstacle)) {
            walls.push_back(&obstacle);
        }
    }
    double const way = shortestWay(walls, from, to, patience);
    if (way < 0) {
        return direct;
    }
    double const along = std::max(nearest, way);
    return std::min(1 / (distance * distance),
                    direct + shareAround(way - length(to - from), frequency) / (along * along));
}

} // namespace trembler
