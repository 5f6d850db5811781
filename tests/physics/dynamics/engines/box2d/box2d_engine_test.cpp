// Many bodies that are removed before Box2D has looked for their contacts. Their cost is measured in
// bench/growth.cpp.
#include "physics/dynamics/engines/box2d/box2d_engine.hpp"

#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

namespace trembler {
namespace {

constexpr SlotIndex blocks = 2500;
constexpr SlotIndex keptOneIn = 50;

/// A row of fixed blocks, some of which will be removed, with a ball above each.
struct Row {
    std::unique_ptr<Engine> engine = makeBox2dEngine(1);
    Shape block{.pieces = {boxPiece(0.2, 0.2)}};
    Shape ball{.pieces = {circlePiece(0.05)}};
    std::vector<Motion> balls;
    std::map<std::pair<ObjectId, ObjectId>, int> touches;

    void add(SlotIndex slot, Shape const& shape, Vec2 at, bool fixed) {
        MassProperties const spread = massPropertiesOf(shape);
        engine->addBody(slot, {.object = {slot, 1},
                               .shape = &shape,
                               .spread = spread,
                               .mass = fixed ? 0 : 1.0,
                               .fixed = fixed,
                               .groups = {},
                               .damping = {},
                               .motion = {.centre = at, .angle = 0, .velocity = {}, .spin = 0}});
    }
    void run() {
        std::vector<Load> loads(blocks + 2 * blocks / keptOneIn);
        for (SlotIndex slot = blocks; slot < loads.size(); ++slot) {
            loads[slot].force = {0, -9.81};
        }
        engine->setLoads(loads);
        balls.resize(loads.size());
        for (int frame = 0; frame < 60; ++frame) {
            engine->step(1.0 / 60, {.substeps = 2});
            for (MovedBody const& moved : engine->moved()) {
                balls[moved.slot] = moved.motion;
            }
            for (TouchChange const& change : std::exchange(engine->touchChanges(), {})) {
                touches[{change.a, change.b}] += change.delta;
            }
        }
    }
};

TEST(Box2dEngine, BodiesRemovedBeforeItsFirstStepHaveNoInfluence) {
    auto const stays = [](SlotIndex slot) { return slot % keptOneIn == 0; };
    auto const placeOf = [](SlotIndex slot) { return Vec2{0.3 * slot, 0}; };
    Row row;
    Row never;
    for (SlotIndex slot = 0; slot < blocks; ++slot) {
        row.add(slot, row.block, placeOf(slot), true);
        if (stays(slot)) {
            never.add(slot, never.block, placeOf(slot), true);
        }
    }
    SlotIndex next = blocks;
    for (SlotIndex slot = 0; slot < blocks; slot += keptOneIn) {
        for (SlotIndex const under : {slot, slot + 1}) { // it touches the block from the beginning
            row.add(next, row.ball, placeOf(under) + Vec2{0, 0.149}, false);
            never.add(next, never.ball, placeOf(under) + Vec2{0, 0.149}, false);
            ++next;
        }
    }
    for (SlotIndex slot = 0; slot < blocks; ++slot) {
        if (!stays(slot)) {
            row.engine->removeBody(slot);
        }
    }
    row.run();
    never.run();
    EXPECT_EQ(row.touches, never.touches);
    EXPECT_EQ(row.touches.size(), blocks / keptOneIn);
    for (SlotIndex slot = blocks; slot < next; ++slot) {
        EXPECT_EQ(row.balls[slot].centre, never.balls[slot].centre) << slot;
        bool const held = (slot - blocks) % 2 == 0;
        EXPECT_EQ(row.balls[slot].centre.y > 0, held) << slot;
    }
}

} // namespace
} // namespace trembler
