// The detail levels of magnetism compared with the sum over all pairs, and the guarantees of the cutoff.
#include "physics/magnetism/magnetic_grid.hpp"
#include "physics/magnetism/magnetic_tree.hpp"
#include "tests/physics/magnetism/magnet_world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

namespace trembler {
namespace magnetic_levels_test {
namespace {

using namespace test;

struct Thing {
    Vec2 at;
    double angle = 0;
    double strength = 0;
    double susceptibility = 0;
    MagneticPoles poles;
};

// Bars with two poles, single poles and irons, in several heaps.
std::vector<Thing> heap(int count, unsigned seed) {
    std::mt19937 random(seed);
    auto const number = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967295.0);
    };
    std::vector<Thing> things;
    Vec2 centre;
    for (int i = 0; i < count; ++i) {
        if (i % 25 == 0) {
            centre = {number(-20, 20), number(-20, 20)};
        }
        Vec2 const at = centre + Vec2{number(-2, 2), number(-2, 2)};
        if (i % 5 == 0) {
            things.push_back({at, 0, 0, number(10, 500), {}});
        } else if (i % 5 == 1) {
            things.push_back({at, 0, number(100, 3000), number(0, 100), {PoleSet::north, {}, {}}});
        } else {
            things.push_back({at, number(-3, 3), number(100, 3000), 0, barPoles(number(0.1, 0.6))});
        }
    }
    return things;
}

using Forces = std::vector<MagneticForce::Entry>;

Forces forces(std::vector<Thing> const& things, std::string const& level, MagnetismSettings settings = {},
              int threads = 1) {
    MagnetWorld magnets(threads);
    for (Thing const& thing : things) {
        ObjectId const id = thing.strength > 0 ? magnets.magnet(thing.at, thing.angle, thing.strength,
                                                                thing.poles, thing.susceptibility)
                                               : magnets.soft(thing.at, thing.susceptibility);
        static_cast<void>(id);
    }
    Store& store = magnets.world.store();
    store.column<MagnetismSettings>().set(store.create("settings"), settings);
    magnets.world.setDetail("magnetism", level);
    magnets.run(1);
    return magnets.forces();
}

// Root of the mean squared difference, relative to the root of the mean squared force.
double difference(Forces const& a, Forces const& b) {
    EXPECT_EQ(a.size(), b.size());
    double wrong = 0;
    double all = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].object, b[i].object);
        EXPECT_EQ(a[i].point, b[i].point);
        wrong += lengthSquared(a[i].force - b[i].force);
        all += lengthSquared(b[i].force);
    }
    return std::sqrt(wrong / all);
}

TEST(MagneticTree, IsExactAtAngleZeroAndSmallerAnglesHaveSmallerErrors) {
    auto const things = heap(400, 1);
    Forces const exact = forces(things, "pairwise");
    double before = 1;
    for (double const angle : {1.0, 0.5, 0.25, 0.0}) {
        double const now = difference(forces(things, "tree", {.openingAngle = angle}), exact);
        EXPECT_LT(now, before) << angle;
        EXPECT_TRUE(angle > 0 ? now > 1e-13 : now < 1e-13) << angle << ": " << now;
        before = now;
    }
    EXPECT_LT(difference(forces(things, "tree"), exact), 3e-3) << "with the default angle";
}

// A bar of any length never acts on itself.
TEST(MagneticTree, NoMagnetActsOnItself) {
    std::vector<Thing> things{{{0, 0}, 0.5, 1e6, 1000, barPoles(50)}};
    for (MagneticForce::Entry const& entry : forces(things, "tree", {.openingAngle = 1})) {
        EXPECT_EQ(entry.force, (Vec2{0, 0}));
    }
    // Weak neighbours make its poles parts of clusters; the force between its poles would be a thousand times
    // that of all others.
    for (int i = 0; i < 200; ++i) {
        double const end = i % 2 == 0 ? -25 : 25;
        things.push_back(
            {rotated({end + 0.02 * (i % 13), 0.03 * (i % 7) - 0.1}, 0.5), 0, 1, 0, {PoleSet::north, {}, {}}});
    }
    Forces const exact = forces(things, "pairwise");
    Forces const tree = forces(things, "tree", {.openingAngle = 1});
    ASSERT_EQ(tree[0].object, exact[0].object);
    for (std::size_t end = 0; end < 2; ++end) {
        EXPECT_LT(length(tree[end].force - exact[end].force), 1e-2 * length(exact[end].force));
    }
}

TEST(MagneticGrid, KeepsForcesWithinTheCutoffAndRemovesThoseBeyond) {
    // Two single poles: the force by distance, in units of the cutoff.
    double const cutoff = 3;
    for (double const share : {0.01, 0.3, 0.79, 0.8, 0.85, 0.9, 0.95, 0.99, 1.0, 1.5, 100.0}) {
        std::vector<Thing> const things{
            {{0.7, -2}, 0, 1000, 0, {PoleSet::north, {}, {}}},
            {Vec2{0.7, -2} + rotated({share * cutoff, 0}, 1.1), 0, 500, 0, {PoleSet::south, {}, {}}}};
        Vec2 const exact = forces(things, "pairwise")[0].force;
        Vec2 const cut = forces(things, "grid", {.cutoff = cutoff})[0].force;
        double const t = (1 - share * share) / (1 - 0.64);
        double const expected = t >= 1 ? 1 : t <= 0 ? 0 : t * t * (3 - 2 * t);
        EXPECT_NEAR(length(cut - expected * exact), 0, 1e-12 * length(exact)) << share;
    }
}

// The same window applied to all pairs of a heap.
TEST(MagneticGrid, IsTheSumOfTheWindowedForcesOfAllPairs) {
    auto const things = heap(300, 2);
    double const cutoff = 2.5;
    Forces const cut = forces(things, "grid", {.cutoff = cutoff});
    Forces const exact = forces(things, "pairwise");
    Forces const nearlyAll = forces(things, "grid", {.cutoff = 1e4});
    EXPECT_LT(difference(nearlyAll, exact), 1e-13);
    // Poles as points with their owners, from the world's properties: strengths by object and place.
    struct Pole {
        ObjectId object;
        Vec2 at;
        double q;
    };
    std::vector<Pole> poles;
    std::vector<Pole> soft;
    for (MagneticForce::Entry const& entry : cut) {
        Thing const& thing = things[entry.object.index];
        bool placed = false;
        if (thing.strength > 0) {
            Vec2 const north = thing.at + rotated(thing.poles.north, thing.angle);
            Vec2 const south = thing.at + rotated(thing.poles.south, thing.angle);
            if (length(entry.point - north) < 1e-12 &&
                (poles.empty() || poles.back().object != entry.object)) {
                poles.push_back({entry.object, entry.point, thing.strength});
                placed = true;
            } else if (thing.poles.poles == PoleSet::both && length(entry.point - south) < 1e-12) {
                poles.push_back({entry.object, entry.point, -thing.strength});
                placed = true;
            }
        }
        if (!placed) {
            soft.push_back({entry.object, entry.point, thing.susceptibility});
        }
    }
    auto const windowed = [&](Vec2 r, double strength) {
        double const t =
            std::clamp((cutoff * cutoff - lengthSquared(r)) / (0.36 * cutoff * cutoff), 0.0, 1.0);
        double const d2 = lengthSquared(r) + 0.0025;
        return (t * t * (3 - 2 * t) * 1e-7 * strength / std::pow(d2, 1.5)) * r; // strength > 0: attraction
    };
    std::size_t nextPole = 0;
    std::size_t nextSoft = 0;
    for (MagneticForce::Entry const& entry : cut) {
        Vec2 expected;
        double scale = 0;
        auto const add = [&](Pole const& from, double strength) {
            if (from.object != entry.object) {
                Vec2 const part = windowed(from.at - entry.point, strength);
                expected += part;
                scale += length(part);
            }
        };
        bool const isPole = nextPole < poles.size() && poles[nextPole].object == entry.object &&
                            poles[nextPole].at == entry.point;
        if (isPole) {
            for (Pole const& pole : poles) {
                add(pole, -poles[nextPole].q * pole.q);
            }
            for (Pole const& iron : soft) {
                add(iron, std::abs(poles[nextPole].q) * iron.q);
            }
            ++nextPole;
        } else {
            for (Pole const& pole : poles) {
                add(pole, std::abs(pole.q) * soft[nextSoft].q);
            }
            ++nextSoft;
        }
        ASSERT_LE(length(entry.force - expected), 1e-12 * scale + 1e-300);
    }
    EXPECT_EQ(nextPole, poles.size());
    EXPECT_EQ(nextSoft, soft.size());
}

// With the derived cutoff, a force that reaches the threshold is unchanged.
TEST(MagneticGrid, ForcesOfTheThresholdOrMoreAreUnchanged) {
    EXPECT_TRUE(rc::check([] {
        auto const number = [](double low, double high) {
            return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
        };
        std::vector<Thing> things;
        for (int i = 0; i < 2; ++i) {
            things.push_back(
                {{number(-5, 5), number(-5, 5)}, 0, number(1, 3000), 0, {PoleSet::north, {}, {}}});
        }
        double const threshold = std::pow(10.0, number(-4, 0));
        Vec2 const exact = forces(things, "pairwise")[0].force;
        Vec2 const cut = forces(things, "grid", {.forceThreshold = threshold})[0].force;
        if (length(exact) >= threshold) {
            RC_ASSERT(length(cut - exact) <= 1e-12 * length(exact));
        } else {
            RC_ASSERT(length(cut - exact) <= threshold);
        }
    }));
}

// The work along a closed path, in and out of the cutoffs of two other poles, is zero; and the force is
// continuous at the cutoff.
TEST(MagneticGrid, CrossingTheCutoffConservesEnergy) {
    auto const forceAt = [](Vec2 at) {
        std::vector<Thing> const things{{at, 0, 1000, 0, {PoleSet::north, {}, {}}},
                                        {{0, 0}, 0, 3000, 0, {PoleSet::south, {}, {}}},
                                        {{1.5, 0.5}, 0, 2000, 0, {PoleSet::north, {}, {}}}};
        return forces(things, "grid", {.cutoff = 2})[0].force;
    };
    auto const work = [&](int steps) {
        double sum = 0;
        double gross = 0;
        for (int i = 0; i < steps; ++i) {
            // Simpson's rule on each piece of an ellipse that leaves and enters both.
            auto const at = [&](double t) {
                double const angle = 2 * pi * t / steps;
                return Vec2{1.2 + 1.9 * std::cos(angle), -0.9 + 1.1 * std::sin(angle)};
            };
            Vec2 const a = at(i);
            Vec2 const b = at(i + 1);
            Vec2 const mean = (forceAt(a) + 4 * forceAt((a + b) / 2) + forceAt(b)) / 6;
            sum += dot(mean, b - a);
            gross += std::abs(dot(mean, b - a));
        }
        return std::abs(sum) / gross;
    };
    EXPECT_LT(work(400), 1e-5);
    double previous = length(forceAt({0, -1.5}));
    for (double y = -1.5; y > -2.1; y -= 0.002) {
        double const now = length(forceAt({0, y}));
        EXPECT_LT(std::abs(now - previous), 1e-3) << y << ": the force must not jump within 0.2 mm";
        previous = now;
    }
    EXPECT_EQ(previous, 0);
}

TEST(MagneticGrid, ActionEqualsReaction) {
    Vec2 total;
    double scale = 0;
    for (MagneticForce::Entry const& entry : forces(heap(300, 3), "grid", {.cutoff = 1.5})) {
        total += entry.force;
        scale += length(entry.force);
    }
    EXPECT_LT(length(total), 1e-13 * scale);
}

TEST(MagneticLevels, AcceptAnyCutoffInAnyWorld) {
    std::vector<Thing> const things{{{-1e6, 1e6}, 0, 1e8, 1e8, barPoles(0.1)},
                                    {{1e6, -1e6}, 0, 1e8, 0, barPoles(0.1)},
                                    {{1e6, -1e6}, 0, 0, 1e8, {}}};
    for (double const cutoff : {1e-6, 1e-3, 1.0, 1e6}) {
        Forces const cut = forces(things, "grid", {.cutoff = cutoff});
        ASSERT_EQ(cut.size(), 6U);
        for (MagneticForce::Entry const& entry : cut) {
            EXPECT_TRUE(isFinite(entry.force));
        }
    }
    Forces const exact = forces(things, "pairwise");
    EXPECT_LT(difference(forces(things, "grid", {.cutoff = 1e3}), exact), 1e-9);
    EXPECT_LT(difference(forces(things, "tree"), exact), 1e-9);
}

TEST(MagneticLevels, DoNotDependOnTheOrderOfPlacing) {
    auto things = heap(300, 4);
    for (std::string const level : {"tree", "grid"}) {
        auto first = forces(things, level, {.cutoff = 3});
        auto reversed = things;
        std::reverse(reversed.begin(), reversed.end());
        auto again = forces(reversed, level, {.cutoff = 3});
        auto const byPlace = [](MagneticForce::Entry const& a, MagneticForce::Entry const& b) {
            return std::tie(a.point.x, a.point.y) < std::tie(b.point.x, b.point.y);
        };
        // An object that is both pole and iron has two entries at one place, in a fixed order.
        std::stable_sort(first.begin(), first.end(), byPlace);
        std::stable_sort(again.begin(), again.end(), byPlace);
        ASSERT_EQ(first.size(), again.size());
        for (std::size_t i = 0; i < first.size(); ++i) {
            ASSERT_EQ(first[i].force, again[i].force) << level << " " << i;
        }
    }
}

TEST(MagneticLevelsParallel, AreTheSameBitsForAnyNumberOfThreads) {
    auto const things = heap(3000, 5);
    for (std::string const level : {"tree", "grid"}) {
        Forces const first = forces(things, level, {}, 1);
        for (int const threads : {2, 3, 8}) {
            Forces const again = forces(things, level, {}, threads);
            ASSERT_EQ(again.size(), first.size());
            for (std::size_t i = 0; i < first.size(); ++i) {
                ASSERT_EQ(again[i].force, first[i].force) << level << " " << i << " on " << threads;
            }
        }
    }
}

TEST(MagneticLevels, TheTreeIsPickedForManyMagnets) {
    auto const levelAtWork = [](int count) {
        MagnetWorld magnets;
        for (int i = 0; i < count; ++i) {
            magnets.magnet({1.0 * i, 0}, 0, 1, {PoleSet::north, {}, {}});
        }
        magnets.run(1);
        for (ComponentStatus const& status : magnets.world.status()) {
            if (status.info->kind == ComponentKind::dps && status.info->text.effect == "magnetism" &&
                status.activity != Activity::absent) {
                return std::string(status.info->text.level);
            }
        }
        return std::string("none");
    };
    EXPECT_EQ(levelAtWork(static_cast<int>(MagneticTree::worthwhile) - 1), "pairwise");
    EXPECT_EQ(levelAtWork(static_cast<int>(MagneticTree::worthwhile)), "tree");
}

// The difference between two poles and a point dipole. In line, at the distance r, bars of the length l
// attract each other with k q² (1/(r-l)² + 1/(r+l)² - 2/r²) = k q² (6 l²/r⁴ + 10 l⁴/r⁶ + 14 l⁶/r⁸ ...); point
// dipoles of the same moment with the first term alone. So poles pull harder by 5/3 (l/r)² to first order,
// and the softening takes a share of some (s/r)².
TEST(MagneticForces, ExceedThoseOfPointDipolesByTheSeries) {
    double const l = 0.5;
    double const q = 1e4;
    for (double const ratio : {3.0, 5.0, 8.0, 12.0}) {
        double const r = ratio * l;
        MagnetWorld magnets;
        ObjectId const a = magnets.magnet({0, 0}, 0, q, barPoles(l));
        magnets.magnet({r, 0}, 0, q, barPoles(l));
        magnets.run(1);
        double const dipoles = 1e-7 * q * q * 6 * l * l / std::pow(r, 4);
        double const excess = magnets.force(a).x / dipoles - 1;
        double const series = 5.0 / 3 / (ratio * ratio) + 7.0 / 3 / std::pow(ratio, 4);
        double const rest = 4 / std::pow(ratio, 6); // the next term, 3 (l/r)^6, and all further ones
        double const softening = 10 * 0.0025 / (r * r);
        EXPECT_NEAR(excess, series, rest + softening) << ratio;
        EXPECT_GT(excess, 0);
    }
}

} // namespace
} // namespace magnetic_levels_test
} // namespace trembler
