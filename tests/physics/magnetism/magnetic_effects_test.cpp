// Which objects are near enough to act on another one: against all pairs of points, at random.
#include "physics/magnetism/magnetic_effects.hpp"
#include "tests/physics/magnetism/magnetic_things.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <vector>

namespace trembler {
namespace magnetic_effects_test {
namespace {

using magnetic_actions::Effect;
using magnetic_actions::Surroundings;
using magnetic_actions::Thing;

/// The amounts of the forces of each other object at each point of `on`, summed.
std::map<ObjectId, double> allPairs(MagneticPoints const& points, ObjectId on) {
    std::map<ObjectId, double> sums;
    for (MagneticSum const sum :
         {MagneticSum::polesOnPoles, MagneticSum::softOnPoles, MagneticSum::polesOnSoft}) {
        auto const receivers = points.receiverObjects(sum);
        auto const sources = points.sourceObjects(sum);
        for (std::size_t i = 0; i < receivers.size(); ++i) {
            std::map<ObjectId, Vec2> here;
            for (std::size_t j = 0; receivers[i] == on && j < sources.size(); ++j) {
                Vec2 const r = points.sources(sum).at(j) - points.receivers(sum).at(i);
                here[sources[j]] +=
                    poleForce(r, points.receivers(sum).weight[i], -points.sources(sum).weight[j]) /
                    magneticConstant;
            }
            for (auto const& [by, force] : here) {
                sums[by] += length(force);
            }
        }
    }
    sums.erase(on);
    return sums;
}

TEST(MagneticEffects, NothingThatActsIsOverlooked) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-60, 60);
    std::uniform_real_distribution<double> unit(0, 1);
    std::size_t left = 0; // pairs that were not looked at
    std::size_t found = 0;
    Surroundings surroundings;
    for (int round = 0; round < 30; ++round) {
        test::MagneticThings things;
        for (int i = 0; i < (round % 2 == 0 ? 20 : 40); ++i) {
            bool const pole = unit(random) < 0.6;
            Vec2 const half{0.5 * unit(random), 0.5 * unit(random)};
            auto const set = static_cast<PoleSet>(1 + static_cast<int>(3 * unit(random)));
            double const strength = pole ? std::pow(10.0, 4 * unit(random)) : 0;
            double const susceptibility = !pole || unit(random) < 0.5 ? std::pow(10.0, 3 * unit(random)) : 0;
            things.thing({place(random), 0.2 * place(random)}, strength, susceptibility,
                         pole ? MagneticPoles{set, half, -half} : MagneticPoles{});
        }
        MagneticPoints points;
        points.gather(things.columns(), 0);
        surroundings.update(points);
        for (Thing const& on : surroundings.things()) {
            std::vector<Effect> const& effects = surroundings.effectsOn(on);
            auto expected = allPairs(points, on.object);
            for (std::size_t i = 0; i < effects.size(); ++i) {
                ASSERT_TRUE(i == 0 || effects[i - 1].by < effects[i].by);
                ASSERT_TRUE(expected.contains(effects[i].by));
                EXPECT_NEAR(effects[i].force, expected.at(effects[i].by), 1e-9 * effects[i].force);
                expected.erase(effects[i].by);
                ++found;
            }
            for (auto const& [by, force] : expected) {
                EXPECT_LT(force, magnetic_actions::endForce) << on.object.index << " by " << by.index;
                ++left;
            }
        }
    }
    EXPECT_GT(found, 500U);
    EXPECT_GT(left, 1000U);
}

} // namespace
} // namespace magnetic_effects_test
} // namespace trembler
