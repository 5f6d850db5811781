// A part that is moved takes along its joints to the world: afterwards its joints are those of a world in
// which it was placed there from the start.
#include "insight/whatif/apply.hpp"
#include "insight/whatif/moved_joints.hpp"
#include "physics/dynamics/properties/joint_anchors.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <memory>

namespace trembler::insight {
namespace moved_joints_test {
namespace {

LevelFile levelFrom(std::string const& members) {
    return readLevel(gameData().registry,
                     JsonDocument::parse(
                         R"({"version": 2, "title": "t", "world": {"gravity": [0, -9.81]}, )" + members + "}",
                         "moved.json"));
}

std::unique_ptr<LevelRun> runOf(LevelFile const& level, std::vector<Placement> const& placements = {}) {
    auto run =
        std::make_unique<LevelRun>(gameData().registry, gameData().parts, level, placements, WorldOptions());
    run->begin();
    return run;
}

Placement placed(std::string const& part, Vec2 at, double angle) {
    Placement placement;
    placement.part = part;
    placement.at = at;
    placement.angle = angle;
    return placement;
}

void move(LevelRun& run, std::string const& object, Vec2 at, double angle) {
    apply(gameData().registry, run,
          {run.world().frame(), {{.kind = Change::Kind::place, .object = object, .at = at, .angle = angle}}});
}

bool near(double a, double b) {
    return std::abs(a - b) < 1e-9;
}
bool near(Vec2 a, Vec2 b) {
    return length(a - b) < 1e-9;
}

template <class P>
P const* valueOf(LevelRun const& run, ObjectId id) {
    return run.world().find<P>(id);
}

/// How many joints are the same in both.
std::size_t expectSameJoints(LevelRun const& a, LevelRun const& b, std::string const& what) {
    auto const* const joints = a.world().store().findColumn<Joint>();
    std::size_t count = 0;
    for (ObjectId const id : joints == nullptr ? std::span<ObjectId const>() : joints->owners()) {
        JointAnchors const* const one = valueOf<JointAnchors>(a, id);
        JointAnchors const* const other = valueOf<JointAnchors>(b, id);
        EXPECT_EQ(one == nullptr, other == nullptr) << what;
        if (one == nullptr || other == nullptr) {
            continue;
        }
        std::string const which = what + ": " + a.world().store().nameOf(id);
        EXPECT_TRUE(near(one->onA, other->onA)) << which;
        EXPECT_TRUE(near(one->onB, other->onB)) << which;
        EXPECT_TRUE(near(one->axis, other->axis)) << which;
        EXPECT_TRUE(near(one->referenceAngle, other->referenceAngle)) << which;
        EXPECT_TRUE(near(one->length, other->length)) << which;
        Joint const& ours = *valueOf<Joint>(a, id);
        Joint const& theirs = *valueOf<Joint>(b, id);
        EXPECT_TRUE(ours.form != JointForm::pulley || near(ours.groundA, theirs.groundA)) << which;
        EXPECT_TRUE(ours.form != JointForm::pulley || near(ours.groundB, theirs.groundB)) << which;
        EXPECT_TRUE(ours.b.valid() || near(ours.at, theirs.at)) << which;
        ++count;
    }
    return count;
}

/// The parts of the game that have joints of their own.
std::vector<std::string> const& jointedParts() {
    static std::vector<std::string> const all = [] {
        std::vector<std::string> names;
        for (std::string const& name : gameData().parts.names()) {
            LevelFile const level =
                levelFrom(R"("objects": [], "toolbox": [{"part": ")" + name + R"(", "count": 1}])");
            auto const run = runOf(level, {placed(name, {0, 3}, 0)});
            if (auto const* const joints = run->world().store().findColumn<Joint>();
                joints != nullptr && !joints->empty()) {
                names.push_back(name);
            }
        }
        return names;
    }();
    return all;
}

RC_GTEST_PROP(MovedJoints, AreThoseOfAPartThatWasPlacedThere, ()) {
    ASSERT_GT(jointedParts().size(), 5U);
    std::string const part = *rc::gen::elementOf(jointedParts());
    auto const somewhere = [] {
        return Vec2{0.01 * *rc::gen::inRange(-300, 300), 0.01 * *rc::gen::inRange(-300, 300)};
    };
    Vec2 const from = somewhere();
    Vec2 const to = somewhere();
    double const before = *rc::gen::inRange(-12, 12) * pi / 12;
    double const after = *rc::gen::inRange(-12, 12) * pi / 12;
    LevelFile const level =
        levelFrom(R"("objects": [], "toolbox": [{"part": ")" + part + R"(", "count": 1}])");
    auto const moved = runOf(level, {placed(part, from, before)});
    auto const there = runOf(level, {placed(part, to, after)});
    std::string const name = moved->world().store().nameOf(moved->objectOf(0));
    Rotation const* const wanted = valueOf<Rotation>(*there, there->objectOf(0));
    move(*moved, name, valueOf<Position>(*there, there->objectOf(0))->value,
         wanted == nullptr ? 0 : wanted->angle);
    RC_ASSERT(expectSameJoints(*moved, *there, part) > 0U);
}

// A cog, whose axle is fixed in the world, stays where it was put.
TEST(MovedJoints, HoldThePartInItsNewPlace) {
    LevelFile const level = levelFrom(R"("objects": [], "toolbox": [{"part": "large cog", "count": 1}])");
    auto const moved = runOf(level, {placed("large cog", {0, 0}, 0)});
    auto const there = runOf(level, {placed("large cog", {2, 1}, 0.5)});
    for (int frame = 0; frame < 20; ++frame) {
        moved->step();
    }
    ObjectId const cog = moved->objectOf(0);
    move(*moved, moved->world().store().nameOf(cog), {2, 1}, 0.5);
    for (int frame = 0; frame < 40; ++frame) {
        moved->step();
        there->step();
    }
    EXPECT_LT(length(valueOf<Position>(*moved, cog)->value - Vec2{2, 1}), 1e-3);
    EXPECT_LT(length(valueOf<Position>(*there, cog)->value - Vec2{2, 1}), 1e-3);
}

// Joints of the level: a pivot in the world or on a fixed post moves along, the far end of a rope does not.
TEST(MovedJoints, OfALevelGoAlongIfTheyArePivots) {
    char const* const members = R"(
        "objects": [
            {{"name": "lever", "at": [{0}, 1],
              "properties": {{"material": "wood", "shape": [{{"form": "box", "width": 1, "height": 0.1}}]}}}},
            {{"name": "post", "at": [-3, 1],
              "properties": {{"material": "wood", "fixed": true,
                            "shape": [{{"form": "box", "width": 0.1, "height": 1}}]}}}},
            {{"name": "sign", "at": [{1}, 1],
              "properties": {{"material": "wood", "shape": [{{"form": "box", "width": 1, "height": 0.1}}]}}}},
            {{"name": "bob", "at": [{2}, 0],
              "properties": {{"material": "wood", "shape": [{{"form": "circle", "radius": 0.1}}]}}}}],
        "joints": [
            {{"name": "axle", "form": "hinge", "a": "lever", "at": [{0}, 1]}},
            {{"name": "nail", "form": "hinge", "a": "sign", "b": "post", "at": [{1}, 1.02]}},
            {{"name": "string", "form": "rope", "a": "bob", "b": "post", "at": [{2}, 0], "at_b": [-3, 1.5],
              "length": 6}}])";
    auto const level = [&](double lever, double sign, double bob) {
        return levelFrom(fmt::format(fmt::runtime(members), lever, sign, bob));
    };
    LevelFile const before = level(0, -2.5, 2);
    LevelFile const after = level(1, -2, 2.5);
    auto const moved = runOf(before);
    auto const there = runOf(after);
    move(*moved, "lever", {1, 1}, 0);
    move(*moved, "sign", {-2, 1}, 0);
    move(*moved, "bob", {2.5, 0}, 0);
    EXPECT_EQ(expectSameJoints(*moved, *there, "level"), 3U);
}

} // namespace
} // namespace moved_joints_test
} // namespace trembler::insight
