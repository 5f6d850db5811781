// Bullets against thin walls, and bodies that overlap at the start.
#include "measure/stability/hard_case.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::stability {
namespace {

// Two hundred lanes side by side, without gravity: a ball of 5 cm and 0.1 kg flies at a wall of 0.1 m and 10
// kg. It has passed through if its centre has crossed the wall's middle plane between the wall's ends, in the
// wall's frame of reference, as an impact may spin the wall.
std::vector<Figure> bullets(Setting const& setting, std::uint64_t seed, double speed, bool free) {
    constexpr std::size_t lanes = 200;
    constexpr double wallHeight = 1;
    Rig rig(setting, seed, {});
    struct Lane {
        ObjectId ball;
        ObjectId wall;
        Vec2 before; // m, of the ball in the wall's frame
        bool passed = false;
    };
    std::vector<Lane> all;
    for (std::size_t i = 0; i < lanes; ++i) {
        Vec2 const wall{0, 3.0 * static_cast<double>(i)};
        Vec2 const ball = wall + Vec2{-5 + 2.5 * rig.jitter(), 0.3 * rig.jitter()};
        ObjectId const id = rig.body(circlePiece(0.05), ball, 0.1);
        rig.give(id, Velocity{{speed, 0}});
        rig.give(id, Bullet{});
        ShapePiece const piece = boxPiece(0.1, wallHeight);
        all.push_back({id, free ? rig.body(piece, wall, 10) : rig.fixed(piece, wall), ball - wall, false});
    }
    double lost = 0; // m/s, in the first frame, before any impact: free flight must not be slowed down
    for (int frame = 1; frame <= 30; ++frame) {
        rig.step();
        for (Lane& lane : all) {
            Vec2 const now = rotated(rig.at(lane.ball) - rig.at(lane.wall), -rig.angle(lane.wall));
            if (!isFinite(now)) {
                lane.passed = true;
            } else if (lane.before.x < 0 && now.x >= 0) {
                double const part = lane.before.x / (lane.before.x - now.x);
                double const y = lane.before.y + part * (now.y - lane.before.y);
                lane.passed = lane.passed || std::abs(y) < wallHeight / 2;
            }
            lane.before = now;
        }
        if (frame == 1) {
            lost = orWorst(speed - rig.fastest());
        }
    }
    auto const passed = std::count_if(all.begin(), all.end(), [](Lane const& lane) { return lane.passed; });
    return {{"passed, of 200", "", 0, static_cast<double>(passed)},
            {"speed lost in flight", "m/s", 0.01 * speed, lost}};
}

// A wall of boxes, each overlapping its neighbours by a quarter.
std::vector<Figure> overlaps(Setting const& setting, std::uint64_t seed) {
    Rig rig(setting, seed);
    rig.fixed(boxPiece(40, 1), {0, -0.5});
    for (int row = 0; row < 5; ++row) {
        for (int i = 0; i < 5; ++i) {
            rig.body(boxPiece(0.5, 0.5),
                     {0.375 * i + 0.005 * rig.jitter(), 0.25 + 0.375 * row + 0.005 * rig.jitter()}, 25);
        }
    }
    double fastest = 0;
    double moved = 0; // m/s, displacement per frame times 60
    std::vector<Vec2> before;
    for (ObjectId const id : rig.bodies()) {
        before.push_back(rig.at(id));
    }
    for (int frame = 0; frame < 300; ++frame) {
        rig.step();
        fastest = std::max(fastest, orWorst(rig.fastest()));
        for (std::size_t i = 0; i < before.size(); ++i) {
            Vec2 const now = rig.at(rig.bodies()[i]);
            moved = std::max(moved, orWorst(length(now - before[i]) * 60));
            before[i] = now;
        }
    }
    return {{"speed", "m/s", 5, fastest},
            // Bodies that the solver pushes apart are displaced without a velocity: reported, but without a
            // limit.
            {"pushed apart at", "m/s", std::numeric_limits<double>::infinity(), moved}};
}

} // namespace

std::vector<HardCase> impactCases() {
    std::vector<HardCase> cases;
    for (int const speed : {100, 300}) {
        for (bool const free : {false, true}) {
            cases.push_back({"bullet against a 0.1 m wall",
                             fmt::format("{} m/s, {}", speed, free ? "free" : "fixed"),
                             [=](Setting const& setting, std::uint64_t seed) {
                                 return bullets(setting, seed, speed, free);
                             }});
        }
    }
    cases.push_back({"25 % overlaps at the start", "", overlaps});
    return cases;
}

} // namespace trembler::stability
