#include "audio/effect/sound_path.hpp"

#include "audio/effect/decibel.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

constexpr double nearest = 0.1;   // m
constexpr double thinnest = 0.01; // m: less of an obstacle than that on the line is no wall
constexpr double worthAWay =
    0.33; // of the energy: what gets more than that through hardly gains by a way around

} // namespace

double shareThrough(double massPerArea, double frequency) {
    double const loss = 20 * std::log10(std::max(1e-9, massPerArea * frequency)) - 47;
    return powerOf(-std::max(0.0, loss));
}

double shareAround(double detour, double frequency) {
    constexpr double most = 24; // dB
    double const fresnel = 2 * std::max(0.0, detour) * frequency / speedOfSound;
    double const loss = std::min(most, 10 * std::log10(3 + 20 * fresnel));
    return powerOf(-loss);
}

double transmission(std::span<Obstacle const> obstacles, std::span<ObjectId const> exempt, Vec2 from, Vec2 to,
                    double frequency, PathDetail detail) {
    double const distance = std::max(nearest, length(to - from));
    std::vector<Obstacle const*> walls;
    for (Obstacle const& obstacle : obstacles) {
        // Sound begins at the surface of what it is in; what is built in is heard outside, and shields it.
        if (std::find(exempt.begin(), exempt.end(), obstacle.object) == exempt.end() &&
            !contains(obstacle, from) && !contains(obstacle, to)) {
            walls.push_back(&obstacle);
        }
    }
    double through = 1;
    double eachAlone = 1;
    for (Obstacle const* const wall : walls) {
        double const chord = chordOf(*wall, from, to);
        if (chord < thinnest) {
            continue;
        }
        double const share = shareThrough(wall->density * chord, frequency);
        through *= share;
        if (detail == PathDetail::straight) {
            double const detour = detourAround(*wall, from, to) - length(to - from);
            eachAlone *= std::min(1.0, share + shareAround(detour, frequency));
        }
    }
    double const direct = through / (distance * distance);
    if (detail == PathDetail::straight) {
        return eachAlone / (distance * distance);
    }
    if (through > worthAWay) {
        return direct;
    }
    double const way = shortestWay(walls, from, to);
    if (way < 0) {
        return direct;
    }
    double const along = std::max(nearest, way);
    return std::min(1 / (distance * distance),
                    direct + shareAround(way - length(to - from), frequency) / (along * along));
}

} // namespace trembler
