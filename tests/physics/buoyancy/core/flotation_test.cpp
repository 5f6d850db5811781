// The areas of liquids that bodies displace, which of them are computed again, and the resulting forces.
#include "physics/buoyancy/core/flotation.hpp"
#include "physics/buoyancy/hulls/exact_hull.hpp"
#include "physics/depth.hpp"
#include "tests/physics/buoyancy/generators.hpp"
#include "tests/physics/buoyancy/oracle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace trembler::test {
namespace flotation_test {
namespace {

/// Shapes, some of which are liquids, and the flotation that observes them.
class Harbour {
public:
    ObjectId body(Shape made, Vec2 at, double angle = 0) {
        ObjectId const id{count_++, 0};
        shape.set(id, std::move(made));
        position.set(id, Position{at});
        rotation.set(id, Rotation{angle});
        return id;
    }
    ObjectId pool(Shape made, Vec2 at, double kilograms, double angle = 0) {
        ObjectId const id = body(std::move(made), at, angle);
        liquid.set(id, {});
        density.set(id, Density{kilograms});
        return id;
    }
    bool follow() {
        return flotation.follow(
            {position, rotation, shape, density, liquid, air, inAir, fixed, sparedBy},
            [&](Shape const& of) {
                ++hulls;
                return std::make_unique<ExactHull>(of);
            },
            [](std::size_t count, std::function<void(std::size_t, std::size_t)> const& run) {
                run(0, count / 2);
                run(count / 2, count);
            });
    }
    std::vector<Immersions::Entry> entries() {
        std::vector<Immersions::Entry> all;
        flotation.gather(all, gravity);
        return all;
    }

    Column<Position> position;
    Column<Rotation> rotation;
    Column<Shape> shape;
    Column<Density> density;
    Column<Liquid> liquid;
    Column<Air> air;
    Column<InAir> inAir;
    Column<Fixed> fixed;
    Column<SparedBy> sparedBy;
    Flotation flotation;
    int hulls = 0;
    Vec2 gravity{0, -9.81};

private:
    std::uint32_t count_ = 0;
};

TEST(Flotation, FindsTheDisplacedAreaOfEachBodyInEachLiquid) {
    EXPECT_TRUE(rc::check("strips across both find the same areas", [] {
        Harbour harbour;
        struct Where {
            Shape shape;
            Vec2 at;
            double angle;
        };
        std::map<ObjectId, Where> liquids;
        std::map<ObjectId, Where> bodies;
        for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
            Where const pool{Shape{{boxPiece(*number(0.5, 3), *number(0.5, 3))}}, *point(2), *number(-1, 1)};
            liquids[harbour.pool(pool.shape, pool.at, 1000 + i, pool.angle)] = pool;
        }
        for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
            Where const body{Shape{{*piece()}}, *point(2), *number(-3, 3)};
            bodies[harbour.body(body.shape, body.at, body.angle)] = body;
        }
        RC_ASSERT(harbour.follow());
        std::map<std::pair<ObjectId, ObjectId>, double> areas;
        std::pair<ObjectId, ObjectId> last;
        for (Immersions::Entry const& entry : harbour.entries()) {
            std::pair const pair{entry.object, entry.liquid};
            RC_ASSERT(areas.empty() || last < pair); // ascending, without duplicates
            last = pair;
            areas[pair] = entry.wet.area;
            RC_ASSERT(entry.density == harbour.density[entry.liquid].value);
            RC_ASSERT(length(entry.up - rotated({0, 1}, liquids[entry.liquid].angle)) < 1e-12);
        }
        for (auto const& [body, b] : bodies) {
            for (auto const& [liquid, l] : liquids) {
                double const right = common(Slab(b.shape.pieces[0], b.at, b.angle),
                                            Slab(l.shape.pieces[0], l.at, l.angle), 1000)
                                         .area;
                RC_ASSERT(std::abs(areas[{body, liquid}] - right) < 0.01 * areaOf(b.shape) + 1e-3);
            }
        }
    }));
}

TEST(Flotation, ComputesAgainOnlyMovedBodies) {
    Harbour harbour;
    ObjectId const water = harbour.pool(Shape{{boxPiece(10, 10)}}, {0, -5}, 1000);
    ObjectId const boat = harbour.body(Shape{{boxPiece(1, 1)}}, {0, 0});
    ObjectId const bird = harbour.body(Shape{{boxPiece(1, 1)}}, {0, 9});
    EXPECT_TRUE(harbour.follow());
    EXPECT_EQ(harbour.hulls, 2);
    EXPECT_FALSE(harbour.follow()) << "nothing has changed";
    harbour.position.set(bird, Position{{1, 9}});
    EXPECT_FALSE(harbour.follow()) << "it was dry and still is";
    harbour.position.set(boat, Position{{0, 0.25}});
    EXPECT_TRUE(harbour.follow());
    ASSERT_EQ(harbour.entries().size(), 1U);
    EXPECT_NEAR(harbour.entries()[0].wet.area, 0.25, 1e-12);
    harbour.rotation.set(water, Rotation{0.1});
    EXPECT_TRUE(harbour.follow()) << "if a liquid moves, all bodies are computed again";
    harbour.density.set(water, Density{800});
    EXPECT_TRUE(harbour.follow());
    EXPECT_EQ(harbour.entries()[0].density, 800);
    EXPECT_EQ(harbour.hulls, 2) << "a hull is made once for each shape";
    harbour.shape.set(boat, Shape{{boxPiece(2, 1)}});
    EXPECT_TRUE(harbour.follow());
    EXPECT_EQ(harbour.hulls, 3);
    harbour.flotation.forgetHulls();
    EXPECT_TRUE(harbour.follow());
    EXPECT_EQ(harbour.hulls, 5);
    harbour.position.set(boat, Position{{0, 50}});
    EXPECT_TRUE(harbour.follow()) << "it has left the water";
    EXPECT_TRUE(harbour.entries().empty());
}

TEST(Flotation, LiquidsFixedAndInvalidBodiesDoNotFloat) {
    Harbour harbour;
    static_cast<void>(harbour.pool(Shape{{boxPiece(10, 10)}}, {}, 1000));
    static_cast<void>(harbour.pool(Shape{{boxPiece(1, 1)}}, {}, 800));
    ObjectId const rock = harbour.body(Shape{{boxPiece(1, 1)}}, {});
    harbour.fixed.set(rock, {});
    static_cast<void>(harbour.body(Shape{{circlePiece(-1)}}, {}));
    static_cast<void>(harbour.pool(Shape{{circlePiece(-1)}}, {}, 1000));
    static_cast<void>(harbour.follow());
    EXPECT_TRUE(harbour.entries().empty());
    EXPECT_EQ(harbour.hulls, 0);
    harbour.fixed.remove(rock);
    EXPECT_TRUE(harbour.follow());
    EXPECT_EQ(harbour.entries().size(), 2U) << "in both liquids, which overlap";
}

Immersions::Entry entryOf(std::uint32_t object, std::uint32_t liquid) {
    Immersions::Entry entry;
    entry.object = {object, 0};
    entry.liquid = {liquid, 0};
    entry.up = {0, 1};
    return entry;
}

TEST(Flotation, ALiquidThatSparesABodyStillActsOnTheOthersAndOtherLiquidsOnIt) {
    Harbour harbour;
    ObjectId const left = harbour.pool({{boxPiece(2, 2)}}, {-1, -1}, 1000);
    ObjectId const right = harbour.pool({{boxPiece(2, 2)}}, {1, -1}, 1200);
    ObjectId const across = harbour.body({{boxPiece(1, 0.2)}}, {0, -0.5});
    ObjectId const other = harbour.body({{boxPiece(0.2, 0.2)}}, {-1, -0.5});
    EXPECT_TRUE(harbour.follow());
    ASSERT_EQ(harbour.entries().size(), 3U);
    int const hulls = harbour.hulls;
    harbour.sparedBy.set(across, {{left}});
    EXPECT_TRUE(harbour.follow());
    EXPECT_EQ(harbour.hulls, hulls);
    std::vector<Immersions::Entry> const entries = harbour.entries();
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].object, across);
    EXPECT_EQ(entries[0].liquid, right);
    EXPECT_EQ(entries[1].object, other);
    EXPECT_EQ(entries[1].liquid, left);
}

TEST(MatchEvents, KeepsTheEventsOfRemainingPairsAndReportsChangesOnce) {
    EXPECT_TRUE(rc::check("the same as sets", [] {
        auto const anySet = [] {
            // A random subset of the twelve pairs.
            auto const chosen = *rc::gen::container<std::vector<bool>>(12, rc::gen::arbitrary<bool>());
            std::set<std::pair<std::uint32_t, std::uint32_t>> set;
            for (std::uint32_t i = 0; i < 12; ++i) {
                if (chosen[i]) {
                    set.emplace(i / 3, i % 3);
                }
            }
            return set;
        };
        auto const then = anySet();
        auto const later = anySet();
        std::vector<Immersions::Entry> before;
        for (auto const& [object, liquid] : then) {
            before.push_back(entryOf(object, liquid));
            before.back().event = EventId{100 + before.size()};
        }
        std::vector<Immersions::Entry> now;
        for (auto const& [object, liquid] : later) {
            now.push_back(entryOf(object, liquid));
        }
        std::set<std::pair<std::uint32_t, std::uint32_t>> entered;
        std::set<std::pair<std::uint32_t, std::uint32_t>> left;
        matchEvents(
            before, now,
            [&](Immersions::Entry const& entry) {
                RC_ASSERT(entered.emplace(entry.object.index, entry.liquid.index).second);
                return EventId{entered.size()};
            },
            [&](Immersions::Entry const& entry) {
                RC_ASSERT(left.emplace(entry.object.index, entry.liquid.index).second);
            });
        for (auto const& pair : then) {
            RC_ASSERT(left.contains(pair) == !later.contains(pair));
        }
        for (Immersions::Entry const& entry : now) {
            std::pair const pair{entry.object.index, entry.liquid.index};
            RC_ASSERT(entered.contains(pair) == !then.contains(pair));
            RC_ASSERT((entry.event.value > 100) == then.contains(pair));
        }
    }));
}

/// Each share's force at its own centroid, about the world's origin.
struct Wrench {
    Vec2 force;
    double torque = 0;
};

// One force at one centre must have the effect of the shares of all liquids.
TEST(SumForces, OneForceHasTheEffectOfAllShares) {
    EXPECT_TRUE(rc::check("force and torque are the sums", [] {
        Pose const pose(*point(5), *number(-3, 3));
        Vec2 const gravity = *point(12);
        std::vector<Immersions::Entry> entries;
        Wrench right;
        double scale = 0;
        auto const count = *rc::gen::inRange(1U, 4U);
        for (std::uint32_t i = 0; i < count; ++i) {
            Immersions::Entry entry = entryOf(0, i);
            entry.density = *number(1, 2000);
            entry.up = rotated({0, 1}, *number(-1, 1));
            double const area = *number(0.01, 2);
            Vec2 const centroid = *point(1);
            entry.wet.area = area;
            entry.wet.first = area * centroid;
            entries.push_back(entry);
            // Archimedes: the weight of the displaced liquid, by the component of gravity into the liquid.
            double const pull = std::max(0.0, -(gravity.x * entry.up.x + gravity.y * entry.up.y));
            Vec2 const force = entry.density * area * worldDepth * pull * entry.up;
            right.force += force;
            right.torque += cross(pose.toWorld(centroid), force);
            scale += length(force);
        }
        BuoyancyForce forces;
        CentreOfBuoyancy centres;
        sumForces(
            entries, gravity, [&](ObjectId) { return pose; }, forces, centres);
        RC_ASSERT(forces.forces.size() == 1 && centres.centres.size() == 1);
        RC_ASSERT(length(forces.forces[0].force - right.force) <= 1e-12 * scale);
        // If the forces nearly cancel, the centre is far away and therefore inexact.
        RC_PRE(length(right.force) > 0.1 * scale || scale == 0);
        RC_ASSERT(length(pose.toWorld(centres.centres[0].centre) - centres.centres[0].world) < 1e-6);
        double const torque = cross(centres.centres[0].world, forces.forces[0].force);
        RC_ASSERT(std::abs(torque - right.torque) <= 1e-9 * (scale * 10 + std::abs(right.torque)));
    }));
}

TEST(SumForces, HaveOneEntryForEachObjectAndTheEventOfTheStrongestShare) {
    std::vector<Immersions::Entry> entries{entryOf(1, 7), entryOf(1, 8), entryOf(4, 7)};
    double const densities[] = {500, 1000, 200};
    for (std::size_t i = 0; i < entries.size(); ++i) {
        entries[i].density = densities[i];
        entries[i].wet.area = 0.5;
        entries[i].event = EventId{i + 1};
    }
    BuoyancyForce forces;
    CentreOfBuoyancy centres;
    auto const upright = [](ObjectId) { return Pose({}, 0); };
    sumForces(entries, {0, -10}, upright, forces, centres);
    ASSERT_EQ(forces.forces.size(), 2U);
    EXPECT_NEAR(forces.forces[0].force.y, 7500 * worldDepth, 1e-9);
    EXPECT_EQ(forces.forces[0].event, EventId{2});
    EXPECT_EQ(forces.forces[1].object, (ObjectId{4, 0}));
    EXPECT_EQ(forces.forces[1].event, EventId{3});
    sumForces(entries, {0, 10}, upright, forces, centres);
    EXPECT_EQ(forces.forces[0].force, (Vec2{})) << "gravity out of the liquid causes no pressure";
    EXPECT_EQ(centres.centres.size(), 2U);
    sumForces({}, {0, -10}, upright, forces, centres);
    EXPECT_TRUE(forces.forces.empty() && centres.centres.empty());
}

} // namespace
} // namespace flotation_test
} // namespace trembler::test
