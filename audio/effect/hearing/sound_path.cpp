#include "audio/effect/hearing/sound_path.hpp"

#include "audio/effect/properties/decibel.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

constexpr double nearest = 0.1;    // m
constexpr double worthAWay = 0.33; // of the energy: if more is transmitted, a way around adds little

/// An obstacle on the line, and the share of energy that goes through it.
struct Crossed {
    std::uint32_t number = 0;
    double share = 0;
};

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
    // Sound begins at the surface of the obstacle that contains its source; a built-in body sounds outside,
    // and so is an obstacle itself.
    auto const inTheWay = [&](Obstacle const& obstacle) {
        return std::find(exempt.begin(), exempt.end(), obstacle.object) == exempt.end() &&
               !contains(obstacle, from) && !contains(obstacle, to);
    };
    thread_local std::vector<Crossed> crossed; // static to reuse its memory
    crossed.clear();
    // A way around a single obstacle is the most expensive to find. So each obstacle first counts with the
    // share that would pass around it without any detour, which ends the computation if that is already too
    // little. Rounding depends on the obstacles' order.
    bool const straight = detail == PathDetail::straight;
    double const tooLittle = straight ? (1 - 1e-9) * least * distance * distance : 0;
    double const mostAround = shareAround(0, frequency);
    double most = 1;
    bool const matters = field.along(from, to, [&](std::uint32_t number) {
        Obstacle const& wall = field.all()[number];
        double const chord = chordOf(wall, from, to);
        if (chord >= thinnestWall && inTheWay(wall)) {
            crossed.push_back({number, shareThrough(wall.density * chord, frequency)});
            most *= std::min(1.0, crossed.back().share + mostAround);
        }
        return most >= tooLittle;
    });
    if (!matters) {
        return 0;
    }
    std::sort(crossed.begin(), crossed.end(),
              [](Crossed const& a, Crossed const& b) { return a.number < b.number; });
    if (straight) {
        double eachAlone = 1;
        for (Crossed const& wall : crossed) {
            double const detour = detourAround(field.all()[wall.number], from, to) - length(to - from);
            eachAlone *= std::min(1.0, wall.share + shareAround(detour, frequency));
            if (eachAlone < least * distance * distance) {
                return 0;
            }
        }
        // Without a wall the distance alone decides.
        return eachAlone < least * distance * distance ? 0 : eachAlone / (distance * distance);
    }
    double through = 1;
    for (Crossed const& wall : crossed) {
        through *= wall.share;
    }
    double const direct = through / (distance * distance);
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
