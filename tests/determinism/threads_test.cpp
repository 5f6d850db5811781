// The number of threads has no influence: the same hash at every 60th frame on 1, 2, 3, 8 and 32 threads.
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"
#include "tests/determinism/level_runs.hpp"
#include "tests/support/sanitizer.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace trembler::determinism {
namespace {

// The thread sanitizer looks for unsynchronised accesses, which are the same in every frame: half a second of
// each run, on one number of threads, is enough for it. Without it, the equality of whole runs is tested.
constexpr std::uint64_t length = test::underThreadSanitizer ? 30 : frames;
std::vector<int> const manyThreads = test::underSanitizer ? std::vector{3, 8} : std::vector{2, 3, 8, 32};

// The levels in four parts, so that several processors can share them.
constexpr std::size_t parts = 4;
class ParallelDeterminismOfLevels : public testing::TestWithParam<std::size_t> {};

TEST_P(ParallelDeterminismOfLevels, IsTheSameOnAnyNumberOfThreads) {
    auto const paths = gameData().levels();
    for (std::size_t i = GetParam(); i < paths.size(); i += parts) {
        LevelFile const level = loadLevel(gameData().registry, paths[i]);
        if (test::underThreadSanitizer) { // it reports races by itself; the hashes are compared without it
            EXPECT_FALSE(hashesOf(level, 3, length).empty());
            continue;
        }
        auto const single = hashesOf(level, 1, length);
        for (int const threads : manyThreads) {
            EXPECT_EQ(single, hashesOf(level, threads, length))
                << paths[i] << " on " << threads << " threads";
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Part, ParallelDeterminismOfLevels, testing::Range(std::size_t{0}, parts));

// Large enough for several chunks per component: magnets, soft iron, circuits, a heap of bodies.
std::vector<std::uint64_t> heapHashes(int threads) {
    WorldOptions options;
    options.threads = threads;
    options.rowsWorthThreads = 0;
    options.trace = threads % 2 == 0; // tracing must not influence the hash either
    World world(gameData().registry, options);
    Store& store = world.store();
    store.column<GravityField>().set(store.create("world"), {{0, -9.81}});
    ObjectId const floor = store.create("floor");
    store.column<Position>().set(floor, {{0, -1}});
    store.column<Shape>().set(floor, {{boxPiece(400, 2)}});
    store.column<Fixed>().set(floor, {});
    for (int i = 0; i < 2500; ++i) {
        ObjectId const id = store.create(fmt::format("thing {:04}", i));
        store.column<Position>().set(id,
                                     {{(i % 250) * 1.1 - 137.0 + 0.01 * (i % 7), 0.5 + 1.05 * (i / 250)}});
        store.column<Shape>().set(id, {{i % 3 == 0 ? circlePiece(0.4) : boxPiece(0.8, 0.8)}});
        store.column<Mass>().set(id, {1.0 + i % 5});
        store.column<Conductor>().set(id, {});
        store.column<MagneticStrength>().set(id, {i % 10 == 0 ? 2000.0 : 0.0, 1500.0});
        if (i % 10 == 0) {
            store.column<MagneticPoles>().set(id, {PoleSet::both, {0.3, 0}, {-0.3, 0}});
        }
        if (i % 500 == 0) {
            store.column<ElectricalSource>().set(id, {});
        }
        if (i % 500 == 250) {
            store.column<ElectricalReturn>().set(id, {});
        }
    }
    world.start();
    std::vector<std::uint64_t> hashes;
    for (int frame = 1; frame <= (test::underThreadSanitizer ? 20 : 30); ++frame) {
        world.step();
        if (frame % 10 == 0) {
            hashes.push_back(world.stateHash());
        }
    }
    return hashes;
}

TEST(ParallelDeterminism, AHeapOfEverythingIsTheSameOnAnyNumberOfThreads) {
    if (test::underThreadSanitizer) {
        EXPECT_FALSE(heapHashes(8).empty()); // with a trace
        return;
    }
    auto const single = heapHashes(1);
    for (int const threads : manyThreads) {
        EXPECT_EQ(single, heapHashes(threads)) << threads << " threads";
    }
}

} // namespace
} // namespace trembler::determinism
