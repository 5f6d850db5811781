// Joints as rows, against derivatives taken by small steps, the conservation laws, and implicit formulas.
#include "physics/dynamics/engines/substepped/joint_rows.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <functional>

namespace trembler {
namespace joint_rows_test {
namespace {

double anyBetween(double low, double high) {
    return low +
           (high - low) * *rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)),
                                        [](int i) { return i / 1e6; });
}

Vec2 anyVector(double reach) {
    double const x = anyBetween(-reach, reach);
    return {x, anyBetween(-reach, reach)};
}

struct Velocity3 {
    Vec2 linear;
    double angular = 0;
};

/// A joint between two bodies, with the data from which its rows are made.
struct Pair {
    Joint joint;
    JointAnchors anchors;
    std::array<JointPose, 2> poses;
    std::array<Velocity3, 2> velocities;

    [[nodiscard]] JointRows rows() const {
        JointSpec spec;
        spec.joint = &joint;
        spec.anchors = anchors;
        spec.a = 0;
        spec.b = 1;
        return JointRows(spec);
    }
    [[nodiscard]] static Vec2 endOf(JointPose const& pose, Vec2 anchor) {
        return pose.centre + rotated(anchor, pose.angle);
    }
};

Pair anyPair(JointForm form) {
    Pair pair;
    pair.joint.form = form;
    pair.joint.stiffness = anyBetween(1, 1e4);
    pair.joint.dampingRate = anyBetween(0, 100);
    pair.joint.ratio = anyBetween(0.2, 3);
    pair.joint.groundA = anyVector(3) + Vec2{0, 10};
    pair.joint.groundB = anyVector(3) + Vec2{0, 10};
    pair.anchors.onA = anyVector(1);
    pair.anchors.onB = anyVector(1);
    pair.anchors.axis = rotated({1, 0}, anyBetween(-3, 3));
    pair.anchors.referenceAngle = anyBetween(-3, 3);
    pair.anchors.length = anyBetween(0.5, 3);
    pair.anchors.lengthB = anyBetween(0.5, 3);
    for (JointPose& pose : pair.poses) {
        pose = {anyVector(2), anyBetween(-3, 3), anyBetween(0.1, 4), anyBetween(0.1, 4)};
    }
    for (Velocity3& velocity : pair.velocities) {
        velocity = {anyVector(3), anyBetween(-3, 3)};
    }
    return pair;
}

double along(JointRow const& row, std::array<Velocity3, 2> const& velocities) {
    double sum = 0;
    for (int i = 0; i < row.count; ++i) {
        RowTerm const& term = row.terms[static_cast<std::size_t>(i)];
        Velocity3 const& v = velocities[static_cast<std::size_t>(term.body)];
        sum += dot(term.linear, v.linear) + term.angular * v.angular;
    }
    return sum;
}

void push(JointRow const& row, double impulse, Pair& pair) {
    for (int i = 0; i < row.count; ++i) {
        RowTerm const& term = row.terms[static_cast<std::size_t>(i)];
        auto const body = static_cast<std::size_t>(term.body);
        pair.velocities[body].linear += pair.poses[body].inverseMass * impulse * term.linear;
        pair.velocities[body].angular += pair.poses[body].inverseInertia * impulse * term.angular;
    }
}

void solve(JointRows& rows, Pair& pair, int rounds) {
    for (int i = 0; i < rounds; ++i) {
        for (JointRow& row : rows.rows()) {
            push(row, row.solve(along(row, pair.velocities)), pair);
        }
    }
}

double anglesApart(Pair const& p) {
    return p.poses[0].angle - p.poses[1].angle;
}
Vec2 endsApart(Pair const& p) {
    return Pair::endOf(p.poses[0], p.anchors.onA) - Pair::endOf(p.poses[1], p.anchors.onB);
}
Vec2 axisOf(Pair const& p) {
    return rotated(p.anchors.axis, p.poses[1].angle);
}

// The quantities that the rows of each form must keep, from the definitions of the joints.
TEST(JointRows, FollowTheirConstraintsAsTheBodiesMove) {
    using Measure = std::function<double(Pair const&)>;
    struct Case {
        JointForm form;
        std::vector<Measure> rows; ///< in the order of the rows
    };
    Measure const turned = anglesApart;
    Measure const apartX = [](Pair const& p) { return endsApart(p).x; };
    Measure const apartY = [](Pair const& p) { return endsApart(p).y; };
    Measure const distance = [](Pair const& p) { return length(endsApart(p)); };
    Measure const slid = [](Pair const& p) { return dot(axisOf(p), endsApart(p)); };
    Measure const off = [](Pair const& p) { return dot(perpendicular(axisOf(p)), endsApart(p)); };
    Measure const slack = [](Pair const& p) { // of a pulley's rope, but for its whole length
        return -(length(Pair::endOf(p.poses[0], p.anchors.onA) - p.joint.groundA) +
                 p.joint.ratio * length(Pair::endOf(p.poses[1], p.anchors.onB) - p.joint.groundB));
    };
    std::vector<Case> const cases{
        {JointForm::hinge, {apartX, apartY}}, {JointForm::weld, {turned, apartX, apartY}},
        {JointForm::slider, {turned, off}},   {JointForm::wheel, {slid, off}},
        {JointForm::distance, {distance}},    {JointForm::spring, {distance}},
        {JointForm::pulley, {slack}},
    };
    for (Case const& c : cases) {
        EXPECT_TRUE(rc::check("a row is the derivative of what it holds", [&] {
            Pair const pair = anyPair(c.form);
            RC_PRE(length(endsApart(pair)) > 0.1);
            JointRows rows = pair.rows();
            rows.prepare(pair.poses, 1.0 / 240);
            RC_ASSERT(rows.rows().size() == c.rows.size());
            for (std::size_t i = 0; i < c.rows.size(); ++i) {
                constexpr double step = 1e-6;
                auto const moved = [&](double t) {
                    Pair there = pair;
                    for (std::size_t body = 0; body < 2; ++body) {
                        there.poses[body].centre += t * pair.velocities[body].linear;
                        there.poses[body].angle += t * pair.velocities[body].angular;
                    }
                    return c.rows[i](there);
                };
                double const rate = (moved(step) - moved(-step)) / (2 * step);
                RC_ASSERT(std::abs(along(rows.rows()[i], pair.velocities) - rate) < 1e-6);
            }
        }));
    }
}

// What a row's rate grows by while no body accelerates, against a difference of rates.
TEST(JointRows, BendAsTheBodiesMoveOn) {
    for (JointForm const form : {JointForm::hinge, JointForm::weld, JointForm::slider, JointForm::wheel,
                                 JointForm::distance, JointForm::rope, JointForm::pulley}) {
        EXPECT_TRUE(rc::check("a row's bend is the derivative of its rate", [&] {
            Pair const pair = anyPair(form);
            RC_PRE(length(endsApart(pair)) > 0.1);
            auto const rowsAt = [&](double t) {
                Pair there = pair;
                for (std::size_t body = 0; body < 2; ++body) {
                    there.poses[body].centre += t * pair.velocities[body].linear;
                    there.poses[body].angle += t * pair.velocities[body].angular;
                    there.poses[body].velocity = pair.velocities[body].linear;
                    there.poses[body].spin = pair.velocities[body].angular;
                }
                JointRows rows = pair.rows();
                rows.prepare(there.poses, 1.0 / 240);
                return rows;
            };
            constexpr double step = 1e-6;
            JointRows now = rowsAt(0);
            JointRows before = rowsAt(-step);
            JointRows after = rowsAt(step);
            for (std::size_t i = 0; i < now.rows().size(); ++i) {
                double const bend =
                    (along(after.rows()[i], pair.velocities) - along(before.rows()[i], pair.velocities)) /
                    (2 * step);
                RC_ASSERT(std::abs(now.rows()[i].bend - bend) < 1e-5 * (1 + std::abs(bend)));
            }
        }));
    }
}

// A joint acts on both its bodies: it conserves momentum and angular momentum.
TEST(JointRows, PushBothBodiesAlike) {
    for (JointForm const form : {JointForm::hinge, JointForm::weld, JointForm::slider, JointForm::wheel,
                                 JointForm::distance, JointForm::rope, JointForm::spring}) {
        EXPECT_TRUE(rc::check("momentum and angular momentum stay", [&] {
            Pair pair = anyPair(form);
            pair.joint.motor = pair.joint.limited = true;
            pair.joint.motorSpeed = anyBetween(-5, 5);
            pair.joint.motorStrength = anyBetween(0, 1e3);
            pair.joint.lower = anyBetween(-1, 0);
            pair.joint.upper = anyBetween(0, 1);
            if (form == JointForm::hinge || form == JointForm::weld) { // these join one point of both bodies
                Vec2 const end = Pair::endOf(pair.poses[0], pair.anchors.onA);
                pair.anchors.onB = rotated(end - pair.poses[1].centre, -pair.poses[1].angle);
            }
            auto const momentum = [&] {
                Vec2 linear;
                double angular = 0;
                for (std::size_t body = 0; body < 2; ++body) {
                    Vec2 const p = pair.velocities[body].linear / pair.poses[body].inverseMass;
                    linear += p;
                    angular += cross(pair.poses[body].centre, p) +
                               pair.velocities[body].angular / pair.poses[body].inverseInertia;
                }
                return Velocity3{linear, angular};
            };
            Velocity3 const before = momentum();
            JointRows rows = pair.rows();
            rows.prepare(pair.poses, 1.0 / 240);
            solve(rows, pair, 10);
            Velocity3 const after = momentum();
            RC_ASSERT(length(after.linear - before.linear) < 1e-9 * (1 + length(before.linear)) * 100);
            RC_ASSERT(std::abs(after.angular - before.angular) < 1e-7 * (1 + std::abs(before.angular)));
        }));
    }
}

TEST(JointRows, HoldAnchorsTogetherWhenTheyAreSolved) {
    for (JointForm const form : {JointForm::hinge, JointForm::weld, JointForm::slider, JointForm::distance}) {
        EXPECT_TRUE(rc::check("no row is missed in the end", [&] {
            Pair pair = anyPair(form);
            JointRows rows = pair.rows();
            rows.prepare(pair.poses, 1.0 / 240);
            solve(rows, pair, 5000);
            for (JointRow const& row : rows.rows()) {
                RC_ASSERT(std::abs(along(row, pair.velocities)) < 1e-6);
            }
        }));
    }
}

Pair onTheWorld(JointForm form) {
    Pair pair;
    pair.joint.form = form;
    pair.poses[0] = {{}, 0, 0.5, 2}; // 2 kg, 0.5 kg m²
    pair.poses[1] = {};              // the world
    return pair;
}

// The implicit Euler method on m v' = -k x - c v: v' = (v - h k x / m) / (1 + h c / m + h² k / m).
TEST(JointRows, ASpringIsAnImplicitStep) {
    EXPECT_TRUE(rc::check("the formula of implicit Euler", [] {
        Pair pair = onTheWorld(JointForm::spring);
        double const k = pair.joint.stiffness = std::pow(10, anyBetween(0, 7));
        double const c = pair.joint.dampingRate = anyBetween(0, 1000);
        pair.anchors.length = 1;
        double const x = anyBetween(-0.5, 2);
        double const v = anyBetween(-5, 5);
        double const h = 1.0 / 240;
        pair.poses[0].centre = {1 + x, 0};
        pair.velocities[0].linear = {v, 7}; // free across the spring
        JointRows rows = pair.rows();
        rows.prepare(pair.poses, h);
        solve(rows, pair, 1);
        double const expected = (v - h * k * x / 2) / (1 + h * c / 2 + h * h * k / 2);
        RC_ASSERT(std::abs(pair.velocities[0].linear.x - expected) < 1e-9 * (1 + std::abs(expected)) * 100);
        RC_ASSERT(pair.velocities[0].linear.y == 7);
        RC_ASSERT(std::abs(rows.impulseOnA().x - 2 * (expected - v)) < 1e-6);
    }));
}

TEST(JointRows, AMotorDrivesWithItsStrength) {
    double const h = 1.0 / 240;
    for (double const strength : {1e9, 10.0}) {
        Pair pair = onTheWorld(JointForm::hinge);
        pair.joint.motor = true;
        pair.joint.motorSpeed = 6;
        pair.joint.motorStrength = strength;
        JointRows rows = pair.rows();
        EXPECT_TRUE(rows.restless());
        rows.prepare(pair.poses, h);
        solve(rows, pair, 20);
        // 10 N m on 0.5 kg m² for h.
        EXPECT_NEAR(pair.velocities[0].angular, std::min(6.0, strength * h / 0.5), 1e-12) << strength;
        EXPECT_NEAR(length(pair.velocities[0].linear), 0, 1e-12);
    }
    Pair idle = onTheWorld(JointForm::hinge);
    idle.joint.motor = true;
    EXPECT_FALSE(idle.rows().restless()) << "at a speed of zero it may sleep";
    idle.joint.form = JointForm::weld;
    idle.joint.motorSpeed = idle.joint.motorStrength = 1;
    EXPECT_FALSE(idle.rows().restless()) << "a weld has no motor";
}

TEST(JointRows, ALimitLetsABodyJustReachIt) {
    double const h = 1.0 / 240;
    auto const after = [&](double angle, double spin) {
        Pair pair = onTheWorld(JointForm::hinge);
        pair.joint.limited = true;
        pair.joint.lower = -0.5;
        pair.joint.upper = 0.25;
        pair.poses[0].angle = angle;
        pair.velocities[0].angular = spin;
        JointRows rows = pair.rows();
        rows.prepare(pair.poses, h);
        solve(rows, pair, 20);
        return pair.velocities[0].angular;
    };
    EXPECT_DOUBLE_EQ(after(0.1, 1), 1) << "far from both limits";
    EXPECT_DOUBLE_EQ(after(0.24, 1), 1) << "it does not reach the limit in this substep";
    EXPECT_NEAR(after(0.24, 10), 0.01 / h, 1e-9) << "it just reaches the limit within a substep";
    EXPECT_NEAR(after(-0.49, -10), -0.01 / h, 1e-9);
    EXPECT_NEAR(after(0.3, 10), 0, 1e-9) << "beyond: no further";
    EXPECT_DOUBLE_EQ(after(0.3, -10), -10) << "it may move back";
}

TEST(JointRows, ARopePullsAndNeverPushes) {
    double const h = 1.0 / 240;
    auto const after = [&](double distance, double speed) {
        Pair pair = onTheWorld(JointForm::rope);
        pair.anchors.length = 2;
        pair.poses[0].centre = {0, -distance};
        pair.velocities[0].linear = {3, -speed};
        JointRows rows = pair.rows();
        rows.prepare(pair.poses, h);
        solve(rows, pair, 5);
        EXPECT_NEAR(pair.velocities[0].linear.x, 3, 1e-12);
        return -pair.velocities[0].linear.y;
    };
    EXPECT_DOUBLE_EQ(after(1, 5), 5);
    EXPECT_DOUBLE_EQ(after(2, -5), -5) << "towards the other end the rope is slack";
    EXPECT_NEAR(after(2, 5), 0, 1e-12);
    EXPECT_NEAR(after(1.99, 5), 0.01 / h, 1e-9) << "up to the length of the rope";
}

// Errors of place vanish by velocities that are forgotten: six tenths of the error in each substep.
TEST(JointRows, ErrorsOfPlaceAreCorrectedApartFromVelocities) {
    double const h = 1.0 / 240;
    Pair pair = onTheWorld(JointForm::distance);
    pair.anchors.length = 1;
    pair.poses[0].centre = {1.02, 0};
    JointRows rows = pair.rows();
    rows.prepare(pair.poses, h);
    ASSERT_EQ(rows.rows().size(), 1U);
    JointRow& row = rows.rows()[0];
    EXPECT_TRUE(row.corrects);
    double const change = row.solveCorrection(0);
    EXPECT_NEAR(change * pair.poses[0].inverseMass * h, -0.6 * 0.02, 1e-12);
    EXPECT_EQ(row.solve(0), 0) << "no impulse at rest";
    EXPECT_EQ(row.impulse, 0);
    // Impulses are kept: solving starts from them in the next substep.
    row.impulse = 3;
    rows.prepare(pair.poses, h);
    EXPECT_EQ(rows.rows()[0].impulse, 3);
    EXPECT_EQ(rows.rows()[0].push, 0);
    // Two ends in one place have no direction, but finite rows.
    pair.poses[0].centre = {};
    rows.prepare(pair.poses, h);
    EXPECT_TRUE(std::isfinite(rows.rows()[0].mass) && std::isfinite(rows.rows()[0].correction));
}

TEST(JointRows, BetweenTwoImmovableBodiesARowHasNoImpulse) {
    Pair pair = onTheWorld(JointForm::weld);
    pair.poses[0].inverseMass = pair.poses[0].inverseInertia = 0;
    JointRows rows = pair.rows();
    rows.prepare(pair.poses, 1.0 / 240);
    for (JointRow& row : rows.rows()) {
        EXPECT_EQ(row.solve(5), 0);
        EXPECT_EQ(row.solveCorrection(5), 0);
    }
}

} // namespace
} // namespace joint_rows_test
} // namespace trembler
