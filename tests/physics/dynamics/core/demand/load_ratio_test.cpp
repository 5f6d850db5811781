// Loads of resting bodies: piles with known loads, and arbitrary heaps compared with a step-by-step
// distribution.
#include "physics/dynamics/core/demand/load_ratio.hpp"
#include "tests/physics/dynamics/core/demand/tied_bodies.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

namespace trembler::test {
namespace load_ratio_test {
namespace {

constexpr double g = 9.81;

TouchingPair pairOf(ObjectId a, ObjectId b) {
    return a < b ? TouchingPair{a, b, {}} : TouchingPair{b, a, {}};
}

double ratioIn(TiedBodies const& tied, std::vector<TouchingPair> const& touching) {
    return loadRatio(tied.columns(), tied.bodies(), touching, tied.loads());
}

// A stack of boxes on the ground, in a world in which `down` points downwards.
double ratioOfStack(std::vector<double> const& masses, Vec2 down) {
    TiedBodies tied;
    std::vector<TouchingPair> touching;
    ObjectId below = tied.fixed({0, 0});
    for (std::size_t i = 0; i < masses.size(); ++i) {
        ObjectId const box = tied.body(-(0.6 + 0.2 * static_cast<double>(i)) * down, masses[i]);
        touching.push_back(pairOf(below, box));
        below = box;
    }
    tied.weigh(g * down);
    tied.settle();
    return ratioIn(tied, touching);
}

TEST(LoadRatio, OfAStackIsTheMassOnItsLowestBox) {
    for (std::size_t const boxes : {1U, 2U, 5U, 30U}) {
        EXPECT_NEAR(ratioOfStack(std::vector<double>(boxes, 2.5), {0, -1}), static_cast<double>(boxes) - 1,
                    1e-9);
    }
    EXPECT_NEAR(ratioOfStack({50, 1, 1000}, {0, -1}), 1000, 1e-9);
}

// Between a floor and a ceiling only the forces determine the direction downwards.
TEST(LoadRatio, DoesNotDependOnDirectionAndStrengthOfGravity) {
    std::vector<double> const masses{3, 1, 20, 7};
    double const upright = ratioOfStack(masses, {0, -1});
    EXPECT_NEAR(upright, 27, 1e-9);
    for (int i = 0; i < 24; ++i) {
        double const angle = i * pi / 12;
        EXPECT_NEAR(ratioOfStack(masses, {std::cos(angle), std::sin(angle)}), upright, 1e-9) << angle;
    }
    EXPECT_NEAR(ratioOfStack(masses, {0, -0.01}), upright, 1e-9);
}

TEST(LoadRatio, NeedsAForceAndAContact) {
    TiedBodies tied;
    ObjectId const light = tied.body({0, 0}, 1);
    ObjectId const heavy = tied.body({0, 0.2}, 1000);
    tied.settle();
    EXPECT_EQ(ratioIn(tied, {pairOf(light, heavy)}), 0) << "no force";
    tied.weigh({0, -g});
    EXPECT_EQ(ratioIn(tied, {}), 0) << "no contact";
    EXPECT_NEAR(ratioIn(tied, {pairOf(light, heavy)}), 1000, 1e-9)
        << "both fall, which forces and contacts do not show";
}

// The forces on a floating body nearly cancel, so it rests on nothing.
TEST(LoadRatio, FloatingBodiesAreNoLoad) {
    TiedBodies tied;
    ObjectId const light = tied.body({0, 0}, 1);
    ObjectId const heavy = tied.body({0, 0.2}, 1000);
    tied.weigh({0, -g});
    tied.pull(heavy, {0, 0.9 * 1000 * g});
    tied.settle();
    EXPECT_EQ(ratioIn(tied, {pairOf(light, heavy)}), 0);
}

TEST(LoadRatio, ABridgeRestsOnItsPiersInEqualShares) {
    TiedBodies tied;
    ObjectId const ground = tied.fixed({0, -1});
    ObjectId const deck = tied.body({0, 2}, 60);
    std::vector<TouchingPair> touching;
    for (double const x : {-1.0, 0.0, 1.0}) {
        ObjectId const pier = tied.body({x, 1}, 4);
        touching.push_back(pairOf(ground, pier));
        touching.push_back(pairOf(deck, pier));
    }
    tied.weigh({0, -g});
    tied.settle();
    EXPECT_NEAR(ratioIn(tied, touching), 60 / 3.0 / 4, 1e-9);
}

// Any heap with equal downward forces: a body carries a share of the load of each body above it.
struct Heap {
    std::vector<double> heights;
    std::vector<double> masses;
    std::vector<std::vector<std::size_t>> on; // by body: the bodies below it; masses.size(): the ground

    [[nodiscard]] double handsOn(std::size_t i) const {
        return (masses[i] + carried(i)) / static_cast<double>(on[i].size());
    }
    [[nodiscard]] double carried(std::size_t i) const {
        double sum = 0;
        for (std::size_t above = 0; above < on.size(); ++above) {
            auto const times = std::count(on[above].begin(), on[above].end(), i);
            sum += times > 0 ? static_cast<double>(times) * handsOn(above) : 0;
        }
        return sum;
    }
};

TEST(LoadRatio, OfAnyHeapAgreesWithDistributingTheLoadsStepByStep) {
    EXPECT_TRUE(rc::check([] {
        Heap heap;
        TiedBodies tied;
        std::vector<ObjectId> ids;
        std::vector<TouchingPair> touching;
        auto const count = static_cast<std::size_t>(*rc::gen::inRange(1, 10));
        ObjectId const ground = tied.fixed({0, -10});
        for (std::size_t i = 0; i < count; ++i) {
            heap.heights.push_back(static_cast<double>(i) + 0.1 * *rc::gen::inRange(0, 9));
            heap.masses.push_back(*rc::gen::inRange(1, 100));
            heap.on.emplace_back();
            ids.push_back(tied.body({1.0 * *rc::gen::inRange(-3, 4), heap.heights[i]}, heap.masses[i]));
            for (std::size_t below = 0; below < i; ++below) {
                if (*rc::gen::inRange(0, 3) == 0) {
                    heap.on[i].push_back(below);
                    touching.push_back(pairOf(ids[i], ids[below]));
                }
            }
            if (*rc::gen::inRange(0, 3) == 0) {
                heap.on[i].push_back(count);
                touching.push_back(pairOf(ids[i], ground));
            }
        }
        tied.weigh({0, -g});
        tied.settle();
        double most = 0;
        for (std::size_t i = 0; i < count; ++i) {
            most = std::max(most, heap.carried(i) / heap.masses[i]);
        }
        double const found = ratioIn(tied, touching);
        RC_LOG() << "found " << found << ", expected " << most << '\n';
        RC_ASSERT(std::abs(found - most) <= 1e-9 * (1 + most));
    }));
}

} // namespace
} // namespace load_ratio_test
} // namespace trembler::test
