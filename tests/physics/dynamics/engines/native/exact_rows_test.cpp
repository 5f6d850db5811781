// The sparse solution against a dense one.
#include "physics/dynamics/engines/native/exact_rows.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Dense>
#include <cmath>

namespace trembler::native {
namespace exact_rows_test {
namespace {

double number() {
    return *rc::gen::inRange(-1000000, 1000001) / 1e6;
}

TEST(ExactRows, AreWhatADenseSolverFinds) {
    EXPECT_TRUE(rc::check([] {
        std::size_t const bodies = *rc::gen::inRange<std::size_t>(2, 9);
        std::vector<MovingState> states(bodies);
        std::vector<double> follows(bodies);
        for (std::size_t i = 0; i < bodies; ++i) {
            states[i].inverseMass = std::pow(10, 2 * number());
            states[i].inverseInertia = std::pow(10, 2 * number());
            follows[i] = *rc::gen::element(0.5, 1.0);
        }
        ExactRows exact;
        std::size_t const rows = *rc::gen::inRange<std::size_t>(1, bodies);
        Eigen::MatrixXd jacobian =
            Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(3 * bodies));
        Eigen::VectorXd weights(static_cast<Eigen::Index>(3 * bodies));
        for (std::size_t i = 0; i < bodies; ++i) {
            auto const at = static_cast<Eigen::Index>(3 * i);
            weights[at] = weights[at + 1] = follows[i] * states[i].inverseMass;
            weights[at + 2] = follows[i] * states[i].inverseInertia;
        }
        std::vector<double> right;
        for (std::size_t i = 0; i < rows; ++i) {
            ExactRow& row = exact.rows().emplace_back();
            row.count = 2;
            for (std::size_t n = 0; n < 2; ++n) {
                ExactTerm& term = row.terms[n];
                term = {static_cast<SlotIndex>(i + n), {number(), number()}, number()};
                auto const at = static_cast<Eigen::Index>(3 * (i + n));
                jacobian(static_cast<Eigen::Index>(i), at) = term.linear.x;
                jacobian(static_cast<Eigen::Index>(i), at + 1) = term.linear.y;
                jacobian(static_cast<Eigen::Index>(i), at + 2) = term.angular;
            }
            right.push_back(number());
        }
        Eigen::MatrixXd const whole = jacobian * weights.asDiagonal() * jacobian.transpose();
        Eigen::JacobiSVD<Eigen::MatrixXd> const svd(whole);
        RC_PRE(svd.singularValues().minCoeff() > 1e-4 * svd.singularValues().maxCoeff());
        RC_ASSERT(exact.factorise(states, follows));
        std::span<double const> const found = exact.solve(right);
        Eigen::VectorXd const x =
            Eigen::Map<Eigen::VectorXd const>(found.data(), static_cast<Eigen::Index>(rows));
        Eigen::VectorXd const b =
            Eigen::Map<Eigen::VectorXd const>(right.data(), static_cast<Eigen::Index>(rows));
        RC_ASSERT((whole * x - b).norm() < 1e-6 * (1 + whole.norm() * x.norm()));
    }));
}

TEST(ExactRows, ThatSayTheSameShareTheLoad) {
    std::vector<MovingState> states(1);
    states[0].inverseMass = 0.5;
    ExactRows exact;
    for (int i = 0; i < 3; ++i) {
        ExactRow& row = exact.rows().emplace_back();
        row.count = 1;
        row.terms[0] = {0, {1, 0}, 0};
    }
    std::vector<double> const follows{1};
    ASSERT_TRUE(exact.factorise(states, follows));
    std::span<double const> const found = exact.solve(std::vector<double>{3, 3, 3});
    EXPECT_NEAR(0.5 * (found[0] + found[1] + found[2]), 3, 1e-6);
}

TEST(ExactRows, ThatAreInactiveHaveNoImpulse) {
    std::vector<MovingState> states(2);
    states[0].inverseMass = states[1].inverseMass = 1;
    ExactRows exact;
    for (SlotIndex slot = 0; slot < 2; ++slot) {
        ExactRow& row = exact.rows().emplace_back();
        row.count = 1;
        row.terms[0] = {slot, {1, 0}, 0};
        row.active = slot == 1;
    }
    std::vector<double> const follows{1, 1};
    ASSERT_TRUE(exact.factorise(states, follows));
    std::span<double const> const found = exact.solve(std::vector<double>{3, 4});
    EXPECT_EQ(found[0], 0);
    EXPECT_NEAR(found[1], 4, 1e-9);
}

} // namespace
} // namespace exact_rows_test
} // namespace trembler::native
