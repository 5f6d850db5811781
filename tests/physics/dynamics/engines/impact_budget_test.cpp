// The limit of impulses against formulas of collisions.
#include "physics/dynamics/engines/impact_budget.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace trembler {
namespace impact_budget_test {
namespace {

using Body = ImpactBudget::Body;

Body ball(double mass, Vec2 centre, Vec2 velocity) {
    return {.inverseMass = 1 / mass, .inverseInertia = 2.5 / mass, .centre = centre, .velocity = velocity};
}

Impact along(Vec2 point, Vec2 normal, double impulse) {
    return {{0, 0}, {1, 0}, point, normal, impulse, 0};
}

double settled(ImpactBudget& budget) {
    std::vector<Impact> impacts;
    budget.settle(impacts);
    return impacts.empty() ? 0 : impacts.front().impulse;
}

TEST(ImpactBudget, EveryCollisionOfTwoBodiesKeepsItsImpulse) {
    std::mt19937 random(1);
    auto const unit = [&] { return static_cast<double>(random() >> 8U) * 0x1p-24; };
    for (int i = 0; i < 300; ++i) {
        double const angle = 6.3 * unit();
        Vec2 const normal{std::cos(angle), std::sin(angle)};
        Body a = ball(0.1 + 10 * unit(), {unit(), unit()}, {4 * unit() - 2, 4 * unit() - 2});
        Body b = ball(0.1 + 10 * unit(), {2 + unit(), unit()}, {4 * unit() - 2, 4 * unit() - 2});
        a.spin = 6 * unit() - 3;
        b.spin = 6 * unit() - 3;
        if (i % 3 == 0) {
            b = {};
        }
        Vec2 const point{1.5 + unit(), unit()};
        double const speed = dot(a.velocityAt(point) - b.velocityAt(point), normal);
        double inverse = 0;
        for (Body const& body : {a, b}) {
            double const arm = cross(point - body.centre, normal);
            inverse += body.inverseMass + arm * arm * body.inverseInertia;
        }
        for (double const restitution : {0.0, 0.5, 0.999999}) {
            double const impulse = (1 + restitution) * speed / inverse; // Newton's law
            ImpactBudget budget;
            budget.begin();
            budget.add(along(point, normal, std::abs(impulse)), 0, a, b);
            if (speed > 0) {
                EXPECT_FALSE(budget.exceeded());
                EXPECT_TRUE(settled(budget) == impulse ||
                            impulse * (a.inverseMass + b.inverseMass) <= faintestImpact);
            } else {
                budget.reset(2);
                EXPECT_EQ(settled(budget), 0) << "they separate";
            }
        }
    }
}

TEST(ImpactBudget, APressureIsNoImpact) {
    ImpactBudget budget;
    budget.begin();
    budget.add(along({0, 0}, {0, -1}, 400), 0, ball(5, {0, 0.2}, {}), {});
    EXPECT_TRUE(budget.exceeded());
    budget.reset(1);
    EXPECT_EQ(settled(budget), 0) << "nothing moves";
    // A motor that presses a body on with its full strength: only the motion counts.
    budget.begin();
    budget.add(along({0, 0}, {0, -1}, 400), 0, ball(5, {0, 0.2}, {0, -0.1}), {});
    budget.reset(1);
    EXPECT_NEAR(settled(budget), 2 * 5 * 0.1, 1e-12);
}

TEST(ImpactBudget, BodiesInBetweenTransmitImpacts) {
    // A ball falls on a wedge that leans on a bell: 2 kg at 3 m/s on 1 kg, which touches 8 kg. The links are
    // given in either direction; a body that has no part in it adds nothing.
    for (bool const linked : {true, false}) {
        for (bool const turned : {true, false}) {
            ImpactBudget budget;
            budget.begin();
            Body const falling = ball(2, {0, 2}, {0, -3});
            Body const wedge = ball(1, {0, 1}, {});
            Body const bell = ball(8, {0, 0}, {});
            Impact leaning = along({0, 0.5}, {0, -1}, 1e6);
            budget.add(leaning, 1, wedge, bell);
            budget.add(along({0, 1.5}, {0, -1}, 5), 0, falling, wedge);
            ASSERT_TRUE(budget.exceeded());
            budget.reset(4);
            if (linked) {
                budget.link(turned ? 1 : 0, turned ? 0 : 1);
                budget.link(turned ? 2 : 1, turned ? 1 : 2);
            }
            budget.lose(0, 2 * 9 / 2.0); // it has come to rest
            budget.lose(3, 1e9);
            std::vector<Impact> impacts;
            budget.settle(impacts);
            ASSERT_EQ(impacts.size(), linked ? 2U : 1U) << turned;
            EXPECT_EQ(impacts.back().impulse, 5) << "of the ball";
            if (linked) {
                double const energy = 9;
                EXPECT_NEAR(impacts.front().impulse, std::sqrt(8 * energy / (1 + 1 / 8.0)), 1e-9) << turned;
            }
        }
    }
}

// A ball between two others, all of one group: its approaches to both are of the same energy.
TEST(ImpactBudget, AGroupHasNoMoreThanItsEnergy) {
    Body const middle = ball(1, {}, {4, 0});
    Body const rest = ball(1, {2, 0}, {});
    for (double const lost : {0.0, 20.0}) {
        ImpactBudget budget;
        budget.begin();
        for (double const side : {-1.0, 1.0}) { // inclined by 60 degrees: half of the speed, twice
            budget.add(along({}, {0.5, side * std::sqrt(0.75)}, 100), 0, middle, rest);
        }
        ASSERT_TRUE(budget.exceeded());
        std::vector<Impact> impacts;
        budget.settleGroup(1.5, lost, impacts);
        ASSERT_EQ(impacts.size(), 2U);
        for (Impact const& impact : impacts) {
            double const arm = cross(impact.point - rest.centre, impact.normal);
            double const inverse = 2 + 2.5 * arm * arm;
            double const own = 2 * 2 / (2 * inverse); // of one approach
            EXPECT_NEAR(impact.impulse,
                        std::sqrt(8 * std::max({own, lost, std::min(2 * own, 1.5)}) / inverse), 1e-9);
        }
    }
}

TEST(ImpactBudget, FixedBodiesAndFaintImpulsesAreLeftOut) {
    ImpactBudget budget;
    budget.begin();
    budget.add(along({}, {0, 1}, 10), 0, {}, {});
    budget.add(along({}, {0, 1}, 0.5 * faintestImpact), 0, ball(1, {}, {0, 5}), {});
    EXPECT_EQ(settled(budget), 0);
}

} // namespace
} // namespace impact_budget_test
} // namespace trembler
