// Motion in a liquid decays according to the formulas, and never reverses.
#include "physics/dynamics/core/drag.hpp"
#include "tests/physics/buoyancy/generators.hpp"
#include "tests/physics/buoyancy/pool.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

TEST(LiquidDrag, MomentumFadesExponentiallyUnderLinearDrag) {
    // As dense as the liquid: no force but drag. v = v0 exp(-c t).
    Pool pool;
    pool.water({.linearDrag = 0.8, .quadraticDrag = 0, .current = {}});
    ObjectId const box = pool.body("box", boxPiece(0.4, 0.2), {0, -5}, 1000);
    ObjectId const heavy = pool.body("heavy", boxPiece(0.4, 0.2), {0, -8}, 4000);
    pool.give(box, Velocity{{2, 0}});
    pool.give(box, AngularVelocity{3});
    pool.give(heavy, Velocity{{2, 0}});
    pool.seconds(2);
    // Drag is known two frames after the start: first the immersed parts, then the force.
    double const time = 2 - 1.0 / 60;
    EXPECT_NEAR(pool.velocity(box).x, 2 * std::exp(-0.8 * time), 0.01);
    EXPECT_NEAR(pool.spin(box), 3 * std::exp(-0.8 * time), 0.02);
    EXPECT_NEAR(pool.velocity(heavy).x, 2 * std::exp(-0.8 * time / 4), 0.02);
    EXPECT_NEAR(pool.at(box).y, -5, 0.01);
}

TEST(LiquidDrag, QuadraticDragAloneFadesAsOneOverTime) {
    // v = v0 / (1 + k v0 t), k = ½ ρ Cd w d / m = Cd w / (2 A) for a body as dense as the liquid.
    Pool pool;
    pool.water({.linearDrag = 0, .quadraticDrag = 1.2, .current = {}});
    ObjectId const box = pool.body("box", boxPiece(0.5, 0.2), {0, -5}, 1000);
    pool.give(box, Velocity{{4, 0}});
    pool.seconds(3);
    double const k = 1.2 * 0.2 / (2 * 0.5 * 0.2);
    EXPECT_NEAR(pool.velocity(box).x, 4 / (1 + k * 4 * (3 - 1.0 / 60)), 0.01);
}

TEST(LiquidDrag, ASinkingBodyReachesItsTerminalVelocity) {
    // (ρ_b - ρ) A g = c1 ρ A v + ½ ρ Cd w v².
    double const c = 0.5;
    double const cd = 1;
    for (double const density : {1050.0, 2000.0, 7800.0}) {
        Pool pool;
        pool.water({.linearDrag = c, .quadraticDrag = cd, .current = {}});
        ObjectId const box = pool.body("box", boxPiece(0.2, 0.2), {0, -1}, density);
        pool.seconds(8);
        double const a = cd / (2 * 0.2);
        double const b = c;
        double const drive = (density / 1000 - 1) * 9.81;
        double const expected = (-b + std::sqrt(b * b + 4 * a * drive)) / (2 * a);
        EXPECT_NEAR(-pool.velocity(box).y / expected, 1, 0.01) << density;
    }
}

TEST(LiquidDrag, APlateSinksFasterEdgeOn) {
    // Width across the motion: 0.6 m broadside on, 0.06 m edge on.
    Pool pool;
    pool.water({.linearDrag = 0, .quadraticDrag = 1, .current = {}});
    ObjectId const flat = pool.body("flat", boxPiece(0.6, 0.06), {0, -1}, 2000);
    ObjectId const edge = pool.body("edge", boxPiece(0.06, 0.6), {5, -1}, 2000);
    pool.seconds(5);
    EXPECT_NEAR(pool.velocity(edge).y / pool.velocity(flat).y, std::sqrt(10), 0.05);
    EXPECT_NEAR(-pool.velocity(flat).y, std::sqrt(2 * 9.81 * 0.06), 0.01);
}

TEST(LiquidDrag, ACurrentCarriesBodiesAlong) {
    Pool pool;
    pool.water({.linearDrag = 1, .quadraticDrag = 1, .current = {0.7, 0}});
    ObjectId const box = pool.body("box", boxPiece(0.4, 0.2), {0, 0}, 500);
    pool.seconds(20);
    EXPECT_NEAR(pool.velocity(box).x, 0.7, 0.01);
    EXPECT_NEAR(pool.velocity(box).y, 0, 0.01);
}

TEST(LiquidDrag, ABodyOutsideOfTheLiquidIsNotSlowedDown) {
    Pool pool;
    pool.water();
    ObjectId const ball = pool.body("ball", circlePiece(0.1), {0, 20}, 500);
    pool.give(ball, Velocity{{3, 0}});
    pool.seconds(1);
    EXPECT_FLOAT_EQ(static_cast<float>(pool.velocity(ball).x), 3);
    EXPECT_EQ(pool.world->find<LiquidResistance>()->entries.size(), 0U);
}

TEST(DragImpulse, SolvesTheImplicitEulerStep) {
    // (M + h D) v' = free, checked by multiplying out; and no motion gains energy by it.
    EXPECT_TRUE(rc::check([] {
        Drag drag;
        int const count = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(1, 4));
        for (int i = 0; i < count; ++i) {
            double const scale = std::pow(10, *number(-3, 6));
            Vec2 const u = *point(1);
            Vec2 const v = *point(1);
            drag.add(*point(2), scale * (u.x * u.x + v.x * v.x), scale * (u.x * u.y + v.x * v.y),
                     scale * (u.y * u.y + v.y * v.y), scale * *number(0, 1));
        }
        double const mass = std::pow(10, *number(-3, 3));
        double const inertia = mass * *number(0.001, 1);
        double const h = *number(0.001, 0.2);
        Twist const free{*point(10), *number(-10, 10)};
        Twist const impulse = dragImpulse(drag, mass, inertia, free, h);
        Vec2 const v = (free.linear + impulse.linear) / mass;
        double const w = (free.angular + impulse.angular) / inertia;
        Vec2 const force{drag.xx * v.x + drag.xy * v.y + drag.xt * w,
                         drag.xy * v.x + drag.yy * v.y + drag.yt * w};
        double const torque = drag.xt * v.x + drag.yt * v.y + drag.tt * w;
        // Each term may be much larger than their sum.
        double const scale = 1 + h * (drag.xx + drag.yy + drag.tt) * (length(v) + std::abs(w));
        RC_ASSERT(length(impulse.linear + h * force) < 1e-7 * scale);
        RC_ASSERT(std::abs(impulse.angular + h * torque) < 1e-7 * scale);
        double const before = lengthSquared(free.linear) / mass + free.angular * free.angular / inertia;
        double const after = mass * lengthSquared(v) + inertia * w * w;
        RC_ASSERT(after <= before * (1 + 1e-9));
    }));
}

TEST(DragImpulse, RefusesInvalidResistances) {
    EXPECT_TRUE(isResistance(1, 0.5, 1, 0));
    EXPECT_TRUE(isResistance(0, 0, 0, 0));
    EXPECT_FALSE(isResistance(-1, 0, 1, 0));
    EXPECT_FALSE(isResistance(1, 1.1, 1, 0));
    EXPECT_FALSE(isResistance(1, 0, 1, -1e-3));
    EXPECT_FALSE(isResistance(std::nan(""), 0, 1, 0));
    EXPECT_FALSE(isResistance(2 * maximumDrag, 0, 1, 0));
}

} // namespace
} // namespace trembler::test
