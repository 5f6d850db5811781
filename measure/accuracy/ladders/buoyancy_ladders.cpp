// Buoyancy ladders: particles against exact, and periods of several frames.
#include "measure/accuracy/ladder.hpp"
#include "measure/accuracy/ladders/effect_clock.hpp"
#include "physics/buoyancy/hulls/exact_hull.hpp"
#include "physics/buoyancy/hulls/particle_hull.hpp"
#include "physics/buoyancy/properties/settings.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <span>

namespace trembler::accuracy {
namespace {

constexpr std::array<int, 7> counts{4, 8, 16, 32, 64, 128, 256};

struct Ride {
    double microseconds = 0;
    std::vector<double> heights; ///< m, height of the raft, by frame
};

Ride ride(GameData const& gameData, std::string const& level, int particles, int period, int frames) {
    LevelFile const file = loadLevel(gameData.registry, gameData.home / "levels/experiments/4-raft.json");
    WorldOptions options;
    options.detail["buoyancy"] = level;
    options.periods[level == "exact" ? "Buoyancy" : "Particle Buoyancy"] = period;
    auto const world = buildWorld(gameData.registry, file, gameData.parts, {}, options);
    BuoyancySettings settings;
    settings.particles = particles;
    world->store().column<BuoyancySettings>().set(world->store().find("world"), settings);
    ObjectId const raft = world->store().find("raft body");
    EffectClock clock("buoyancy");
    Ride found;
    for (int frame = 0; frame < frames; ++frame) {
        world->step();
        clock.frame(*world);
        found.heights.push_back(world->find<Position>(raft)->value.y);
    }
    found.microseconds = clock.median();
    return found;
}

double greatestDeviation(Ride const& found, Ride const& right) {
    double most = 0;
    for (std::size_t i = 0; i < right.heights.size(); ++i) {
        most = std::max(most, std::abs(found.heights[i] - right.heights[i]));
    }
    return most;
}

Ladder climbRaft(GameData const& gameData, Effort effort) {
    int const frames = effort.brief ? 40 : 600;
    Ladder ladder{
        "",      "Experiment IV's raft",
        "m",     fmt::format("greatest deviation of the raft's height, over {:g} s", frames * frameDuration),
        "exact", true,
        {},      {}};
    Ride const right = ride(gameData, "exact", 64, 1, frames);
    for (int const count : counts) {
        if (!effort.brief || count % 60 == 4) {
            Ride const found = ride(gameData, "particles", count, 1, frames);
            ladder.rungs.push_back({fmt::format("{} particles", count),
                                    found.microseconds,
                                    greatestDeviation(found, right),
                                    {},
                                    false,
                                    {}});
        }
    }
    ladder.rungs.push_back({"exact", right.microseconds, 0, {}, false, {}});
    ladder.remark = "Half of the time is drag, which is the same at every level, so few particles save "
                    "nothing. A scene uses exact unless particles are requested.";
    return ladder;
}

Ladder climbPeriods(GameData const& gameData, Effort effort) {
    int const frames = effort.brief ? 40 : 600;
    Ladder ladder{"",
                  "Experiment IV's raft, exact, now and then",
                  "m",
                  fmt::format("greatest deviation of the raft's height, over {:g} s", frames * frameDuration),
                  "every frame",
                  true,
                  {},
                  {}};
    Ride const right = ride(gameData, "exact", 64, 1, frames);
    ladder.rungs.push_back({"every frame", right.microseconds, 0, {}, false, {}});
    for (int period = 2; period <= (effort.brief ? 3 : 12); ++period) {
        Ride const found = ride(gameData, "exact", 64, period, frames);
        ladder.rungs.push_back({fmt::format("every {} frames", period),
                                found.microseconds,
                                greatestDeviation(found, right),
                                {},
                                false,
                                {}});
    }
    ladder.remark =
        "From a period of five on the remaining time is drag, which is computed in every frame: a longer "
        "period saves too little time for its error. The error is not a smooth function of the period, as "
        "the positions of the boxes on the deck depend on when they land ([buoyancy.md](../buoyancy.md)).";
    return ladder;
}

// A box cut by the surface at many attitudes: the error of the particles alone, without its effect on motion.
Ladder climbCuts(GameData const&, Effort effort) {
    constexpr double width = 0.6;  // m, the raft's float
    constexpr double height = 0.4; // m
    Ladder ladder{"",
                  "one float, in all attitudes",
                  "of the greatest lift",
                  "mean error of the lift; times are per cut",
                  "a rectangle cut by a line (closed form)",
                  true,
                  {},
                  {}};
    std::vector<Side> surfaces;
    int const angles = effort.brief ? 7 : 90;
    for (int i = 0; i < angles; ++i) {
        double const angle = pi * i / angles;
        Vec2 const normal{std::cos(angle), std::sin(angle)};
        double const reach = (width * std::abs(normal.x) + height * std::abs(normal.y)) / 2;
        for (int k = 1; k < 41; ++k) {
            surfaces.push_back({normal, reach * (2.0 * k / 41 - 1)});
        }
    }
    Shape const shape{{boxPiece(width, height)}};
    auto const wet = [&](Hull const& hull, Side const& surface) {
        return hull.displaced(std::span(&surface, 1), surface.normal).wet.area;
    };
    // A closed form independent of both hulls: the depth of a random point of the box is the sum of two
    // uniformly distributed numbers of the widths a and b, so the share of the box below a depth is a sum of
    // four parabolas.
    auto const closedForm = [&](Side const& surface) {
        double const a = width * std::abs(surface.normal.x);
        double const b = height * std::abs(surface.normal.y);
        double const depth = surface.offset + (a + b) / 2;
        auto const ramp = [](double x) { return std::max(x, 0.0) * std::max(x, 0.0) / 2; };
        if (a * b < 1e-12) {
            return width * height * std::clamp(depth / (a + b), 0.0, 1.0);
        }
        return width * height * (ramp(depth) - ramp(depth - a) - ramp(depth - b) + ramp(depth - a - b)) /
               (a * b);
    };
    auto const add = [&](std::string name, Hull const& hull) {
        double error = 0;
        for (Side const& surface : surfaces) {
            error += std::abs(wet(hull, surface) - closedForm(surface)) / (width * height);
        }
        std::vector<double> times;
        double sum = 0;
        for (int repetition = 0; repetition < (effort.brief ? 3 : 31); ++repetition) {
            auto const begin = std::chrono::steady_clock::now();
            for (Side const& surface : surfaces) {
                sum += wet(hull, surface);
            }
            std::chrono::duration<double, std::micro> const took = std::chrono::steady_clock::now() - begin;
            times.push_back(took.count() / static_cast<double>(surfaces.size()));
        }
        ladder.rungs.push_back({std::move(name),
                                sum < 0 ? 0 : medianOf(times),
                                error / static_cast<double>(surfaces.size()),
                                {},
                                false,
                                {}});
    };
    for (int const count : counts) {
        add(fmt::format("{} particles", count), ParticleHull(shape, count));
    }
    add("exact", ExactHull(shape));
    ladder.remark =
        "Particles are the level of the thesis (6.13), and are kept for that reason: boxes, discs, polygons "
        "and capsules are cut exactly in less time than eight particles take, so a scene uses exact unless "
        "particles are requested. The fit of the particles to the float matters as much as their number: 8 "
        "are hardly better than 4, and 32 no better than 16.";
    return ladder;
}

} // namespace

void addBuoyancyPlans(std::vector<Plan>& plans) {
    plans.push_back({"buoyancy", climbCuts});
    plans.push_back({"buoyancy", climbRaft});
    plans.push_back({"buoyancy", climbPeriods});
}

} // namespace trembler::accuracy
