// Resistance to motion, against the equations that it solves and the laws that it must not break.
#include "physics/dynamics/core/drag.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler {
namespace drag_test {
namespace {

double anyBetween(double low, double high) {
    return low +
           (high - low) * *rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)),
                                        [](int i) { return i / 1e6; });
}

double anyPower(double from, double to) {
    return std::pow(10, anyBetween(from, to));
}

/// One resistance at one point, as the sum of two along perpendicular directions.
struct Paddle {
    Vec2 arm;
    double xx = 0;
    double xy = 0;
    double yy = 0;
    double angular = 0;
};

Paddle anyPaddle(double orders) {
    Vec2 const along = rotated({1, 0}, anyBetween(-3, 3));
    Vec2 const across = perpendicular(along);
    double const p = anyPower(-orders, orders);
    double const q = anyPower(-orders, orders);
    return {{anyBetween(-2, 2), anyBetween(-2, 2)},
            p * along.x * along.x + q * across.x * across.x,
            p * along.x * along.y + q * across.x * across.y,
            p * along.y * along.y + q * across.y * across.y,
            anyPower(-orders, orders)};
}

/// The force and the torque about the centre on a moving body, summed over the paddles.
Twist resistanceTo(std::vector<Paddle> const& paddles, Vec2 v, double spin) {
    Twist sum;
    for (Paddle const& paddle : paddles) {
        Vec2 const there = v + spin * perpendicular(paddle.arm);
        Vec2 const force{-(paddle.xx * there.x + paddle.xy * there.y),
                         -(paddle.xy * there.x + paddle.yy * there.y)};
        sum.linear += force;
        sum.angular += cross(paddle.arm, force) - paddle.angular * spin;
    }
    return sum;
}

TEST(Drag, ImpulseIsThatOfTheVelocityAfterwards) {
    EXPECT_TRUE(rc::check("implicit Euler: (M + h D) v' = free", [] {
        std::vector<Paddle> paddles;
        Drag drag;
        for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
            paddles.push_back(anyPaddle(4));
            Paddle const& p = paddles.back();
            RC_ASSERT(isResistance(p.xx, p.xy, p.yy, p.angular));
            drag.add(p.arm, p.xx, p.xy, p.yy, p.angular);
        }
        RC_ASSERT(drag.any());
        double const mass = anyPower(-2, 2);
        double const inertia = anyPower(-3, 2);
        double const h = anyPower(-4, -1);
        Twist const free{{anyBetween(-5, 5), anyBetween(-5, 5)}, anyBetween(-5, 5)};
        Twist const impulse = dragImpulse(drag, mass, inertia, free, h);
        Vec2 const v = (free.linear + impulse.linear) / mass;
        double const spin = (free.angular + impulse.angular) / inertia;
        Twist const felt = resistanceTo(paddles, v, spin);
        double const scale = length(free.linear) + std::abs(free.angular) + h * length(felt.linear) +
                             h * std::abs(felt.angular);
        RC_ASSERT(length(impulse.linear - h * felt.linear) <= 1e-6 * scale);
        RC_ASSERT(std::abs(impulse.angular - h * felt.angular) <= 1e-6 * scale);
        // It removes energy, but not more than the body has.
        auto const energy = [&](Vec2 momentum, double turning) {
            return lengthSquared(momentum) / mass + turning * turning / inertia;
        };
        RC_ASSERT(energy(free.linear + impulse.linear, free.angular + impulse.angular) <=
                  energy(free.linear, free.angular) * (1 + 1e-9));
    }));
}

TEST(Drag, OfAnyStrengthStopsABodyAndNeverReversesIt) {
    for (double const coefficient : {1e3, 1e9, maximumDrag}) {
        Drag drag;
        drag.add({}, coefficient, 0, coefficient, coefficient);
        Twist const free{{3, -4}, 5};
        Twist const impulse = dragImpulse(drag, 1e-3, 1e-4, free, 1.0 / 60);
        for (auto const& [before, change] :
             {std::pair{free.linear.x, impulse.linear.x}, std::pair{free.linear.y, impulse.linear.y},
              std::pair{free.angular, impulse.angular}}) {
            double const after = before + change;
            EXPECT_GE(after * before, 0) << coefficient;
            EXPECT_LT(std::abs(after), std::abs(before)) << coefficient;
        }
    }
    Twist const none = dragImpulse({}, 2, 3, {{1, 1}, 1}, 1);
    EXPECT_EQ(none.linear, (Vec2{}));
    EXPECT_EQ(none.angular, 0);
}

// Whether it is positive semidefinite, by the least eigenvalue.
TEST(Drag, RefusesMatricesThatWouldAccelerate) {
    EXPECT_TRUE(rc::check("the eigenvalues of a symmetric 2 by 2 matrix", [] {
        double const xx = anyBetween(-1, 5);
        double const yy = anyBetween(-1, 5);
        double const xy = anyBetween(-5, 5);
        double const least = (xx + yy) / 2 - std::hypot((xx - yy) / 2, xy);
        RC_PRE(std::abs(least) > 1e-6);
        RC_ASSERT(isResistance(xx, xy, yy, 0) == (least > 0));
    }));
    EXPECT_TRUE(isResistance(4, 2, 1, 0)) << "resists along one direction only";
    EXPECT_FALSE(isResistance(1, 0, 1, -1e-9));
    EXPECT_TRUE(isResistance(maximumDrag, 0, 0, maximumDrag));
    EXPECT_FALSE(isResistance(1.01 * maximumDrag, 0, 0, 0));
    EXPECT_FALSE(isResistance(0, 0, 0, 1.01 * maximumDrag));
    EXPECT_FALSE(isResistance(std::nan(""), 0, 1, 0));
    EXPECT_FALSE(isResistance(1, std::nan(""), 1, 0));
}

// A stone that sinks: m v' = m g - d v, which ends at m g / d.
TEST(DraggedBody, FallsAtTheSpeedAtWhichDragCarriesTheWeight) {
    for (double const coefficient : {0.5, 50.0, 5e4}) {
        DraggedBody body;
        body.drag.add({}, coefficient, 0, coefficient, 0);
        double const mass = 2;
        double const h = 1.0 / 240;
        double const weight = -mass * 9.81;
        double momentum = 0;
        double exact = 0;
        double worst = 0;
        for (int i = 0; i < 8000; ++i) {
            Twist const impulse = body.before(mass, 1, {{0, momentum}, 0}, {{0, weight * h}, 0}, h);
            momentum += impulse.linear.y + weight * h; // no other forces
            body.after({{0, momentum}, 0});
            exact = weight / coefficient * (1 - std::exp(-coefficient / mass * h * (i + 1)));
            worst = std::max(worst, std::abs(momentum / mass - exact));
        }
        double const last = weight / coefficient;
        EXPECT_NEAR(momentum / mass, last, 1e-3 * std::abs(last)) << coefficient;
        EXPECT_LE(worst, 0.5 * 9.81 * h + 1e-9)
            << "while accelerating, within half a substep's change of speed";
    }
}

// A body at rest on the ground has no drag, although its load would accelerate a falling one.
TEST(DraggedBody, HasNoDragFromALoadThatTheGroundCarries) {
    DraggedBody body;
    body.drag.add({}, 40, 0, 40, 1);
    double const h = 1.0 / 240;
    Twist const load{{0, -20 * h}, 0};
    double before = HUGE_VAL;
    for (int i = 0; i < 14; ++i) {
        double const drag = std::abs(body.before(2, 1, {}, load, h).linear.y);
        EXPECT_LT(drag, 0.1 * before) << i;
        before = drag;
        body.after({}); // the ground carries the load: the body is at rest
    }
    EXPECT_LT(before, 1e-14 * 20 * h);
    // A push of the ground beyond the load moves the body, so there is drag.
    Twist const pushed = body.before(2, 1, {{0, 3}, 0}, load, h);
    EXPECT_LT(pushed.linear.y, 0);
}

} // namespace
} // namespace drag_test
} // namespace trembler
