// Bodies that float, sink or hit the water fast: numbers stay finite, and bodies stay near their expected
// places.
#include "tests/physics/buoyancy/generators.hpp"
#include "tests/physics/buoyancy/pool.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

class Extremes : public ::testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] static Pool::Options options() {
        Pool::Options options;
        options.detail = GetParam();
        return options;
    }
};

INSTANTIATE_TEST_SUITE_P(Levels, Extremes, ::testing::Values("exact", "particles"),
                         [](auto const& info) { return info.param; });

TEST_P(Extremes, AnyDensityStaysFiniteAndLightBodiesDoNotFlyAway) {
    Pool pool(options());
    pool.water();
    pool.withoutAir(); // in air the lightest of these bodies would rise further
    pool.fixed("floor", boxPiece(100, 1), {0, -12.5});
    std::vector<std::pair<ObjectId, double>> bodies;
    int column = 0;
    for (int exponent = -6; exponent <= 6; ++exponent) {
        double const ratio = std::pow(10, exponent / 2.0);
        for (ShapePiece const& piece :
             {boxPiece(0.5, 0.2), circlePiece(0.2), capsulePiece(0.6, 0.1), boxPiece(0.8, 0.012)}) {
            std::string const name = "body " + std::to_string(column);
            bodies.emplace_back(pool.body(name, piece, {-45 + 1.7 * column, -3}, 1000 * ratio, 0.3), ratio);
            ++column;
        }
    }
    double highest = 0;
    for (int frame = 0; frame < 900; ++frame) {
        pool.run(1);
        for (auto const& [id, ratio] : bodies) {
            ASSERT_TRUE(isFinite(pool.at(id)) && isFinite(pool.velocity(id))) << ratio;
            highest = std::max(highest, pool.at(id).y);
        }
    }
    // From a depth of 3 m a cork without drag would rise by 3 m times the ratio of the densities; with drag,
    // it rises only a little.
    EXPECT_LT(highest, 1.5);
    for (auto const& [id, ratio] : bodies) {
        if (ratio < 0.9) {
            EXPECT_NEAR(pool.at(id).y, 0, 0.5) << ratio;
            EXPECT_LT(length(pool.velocity(id)), 0.1) << ratio;
        } else if (ratio > 1.1) {
            EXPECT_LT(pool.at(id).y, -11) << ratio;
        }
    }
}

TEST_P(Extremes, AFastBodyStopsInTheWater) {
    Pool pool(options());
    pool.water();
    pool.withoutAir(); // in air bodies of 1 kg/m³ would rise
    pool.fixed("floor", boxPiece(100, 4), {0, -52});
    std::vector<ObjectId> bodies;
    for (double const speed : {10.0, 100.0, 1000.0}) {
        for (double const density : {1.0, 30.0, 600.0}) {
            ObjectId const id = pool.body("body " + std::to_string(bodies.size()), boxPiece(0.4, 0.2),
                                          {-20 + 5.0 * static_cast<double>(bodies.size()), 2}, density, 0.2);
            pool.give(id, Velocity{{0, -speed}});
            pool.give(id, AngularVelocity{50});
            pool.give(id, Bullet{});
            bodies.push_back(id);
        }
    }
    pool.seconds(40);
    for (ObjectId const id : bodies) {
        EXPECT_TRUE(isFinite(pool.at(id)));
        EXPECT_LT(length(pool.velocity(id)), 1);
        EXPECT_NEAR(pool.at(id).y, 0, 0.5) << pool.world->store().nameOf(id);
    }
}

TEST_P(Extremes, RandomHullsComeToRestInAnEquilibrium) {
    // At rest, a body's weight is that of the displaced liquid, and its centre of buoyancy is vertically
    // below or above its centre of mass.
    bool const ok = rc::check([] {
        Pool pool(options());
        Liquid thick;
        thick.linearDrag = 4;
        pool.water(thick);
        Shape shape{{*piece()}};
        if (*rc::gen::arbitrary<bool>()) {
            shape.pieces.push_back(*piece());
        }
        double const ratio = *number(0.05, 0.95);
        ObjectId const id = pool.body("body", shape, {0, *number(-1, 1)}, 1000 * ratio, *number(-3, 3));
        pool.seconds(60);
        RC_ASSERT(isFinite(pool.at(id)));
        double const weight = pool.mass(id) * 9.81;
        bool const coarse = GetParam() == "particles";
        RC_ASSERT(std::abs(pool.force(id).y / weight - 1) < (coarse ? 0.05 : 0.01));
    });
    EXPECT_TRUE(ok);
}

TEST_P(Extremes, LongPeriodsStayFinite) {
    for (int const period : {2, 5, 12, 60}) {
        Pool::Options slow = options();
        slow.period = period;
        Pool pool(slow);
        pool.water();
        ObjectId const cork = pool.body("cork", boxPiece(0.4, 0.2), {0, -1}, 20);
        ObjectId const log = pool.body("log", boxPiece(0.6, 0.3), {3, 0.5}, 700);
        for (int frame = 0; frame < 1200; ++frame) {
            pool.run(1);
            ASSERT_LT(std::abs(pool.at(cork).y), 20) << period;
            ASSERT_LT(std::abs(pool.at(log).y), 20) << period;
        }
    }
}

} // namespace
} // namespace trembler::test
