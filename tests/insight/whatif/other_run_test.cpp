// The other run: without a change it equals the real run to the bit, the same change gives the same run
// again, and the real run never changes.
#include "insight/timeline/again.hpp"
#include "insight/timeline/stage.hpp"
#include "insight/whatif/other_run.hpp"
#include "insight/whatif/settable.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "runtime/input/input_resolver.hpp"
#include "runtime/placement.hpp"
#include "tests/support/experiment.hpp"

#include <rapidcheck/gtest.h>

#include <memory>

namespace trembler::insight {
namespace {

char const* const otherLevels[] = {"1-switched-electromagnet.json", "2-doorbell.json", "4-raft.json"};

class OtherRunTest : public Experiment {
protected:
    [[nodiscard]] std::unique_ptr<OtherRun> computed(WhatIf what) {
        auto run = std::make_unique<OtherRun>(gameData().registry, session(), std::move(what));
        while (run->advance(50, world().frame())) {
        }
        return run;
    }
    /// Grabs and cuts at random frames, of objects of the level.
    void runWith(std::vector<std::pair<int, int>> const& acts, std::uint64_t frames) {
        session().start();
        Store const& store = world().store();
        places_.clear();
        std::vector<ObjectId> bodies;
        for (ObjectId const id : store.findColumn<Velocity>()->owners()) {
            bodies.push_back(id);
        }
        while (world().frame() < frames) {
            for (auto const& [frame, what] : acts) {
                if (static_cast<std::uint64_t>(frame) == world().frame()) {
                    ObjectId const object = bodies[static_cast<std::size_t>(what) % bodies.size()];
                    auto const kind = static_cast<PlayerInput::Kind>(what % 3);
                    Vec2 const at = store.findColumn<Position>()->find(object)->value + Vec2{0.1, 0.3};
                    session().feed({kind, object, {}, at});
                }
            }
            places_.push_back(placesNow());
            step();
        }
    }
    /// Changes that put each body where it already is.
    [[nodiscard]] std::vector<Change> placesNow() const {
        std::vector<Change> all;
        Store const& store = world().store();
        for (ObjectId const id : store.findColumn<Velocity>()->owners()) {
            all.push_back({.kind = Change::Kind::place,
                           .object = store.nameOf(id),
                           .at = world().find<Position>(id)->value,
                           .angle = world().find<Rotation>(id)->angle});
        }
        return all;
    }

    std::vector<std::vector<Change>> places_; // before each frame
};

RC_GTEST_FIXTURE_PROP(OtherRunTest, NeverDiffersWithoutAChange, ()) {
    open(otherLevels[*rc::gen::inRange(0, 3)]);
    auto const acts = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(0, 120), rc::gen::inRange(0, 30)));
    runWith(acts, 120);
    WhatIf what{.frame = *rc::gen::inRange<std::uint64_t>(0, 120), .changes = {}};
    if (*rc::gen::arbitrary<bool>()) { // nothing changes either if everything is put where it is
        what.changes = places_[what.frame];
    }
    std::uint64_t const hash = world().stateHash();
    auto const other = computed(what);
    RC_ASSERT(!other->firstDifference());
    RC_ASSERT(other->frame() == 120U);
    RC_ASSERT(other->run().world().stateHash() == hash);
    RC_ASSERT(other->paths().empty());
    RC_ASSERT(world().stateHash() == hash);
}

TEST_F(OtherRunTest, IsTheSameAgainWithTheSameChange) {
    open("2-doorbell.json");
    runTo(150);
    std::uint64_t const hash = world().stateHash();
    for (Change::Kind const kind : {Change::Kind::place, Change::Kind::remove, Change::Kind::grab}) {
        std::string name;
        for (ObjectId const id : world().store().findColumn<Velocity>()->owners()) {
            name = world().find<Fixed>(id) == nullptr ? world().store().nameOf(id) : name;
        }
        WhatIf const what{40,
                          {{.kind = kind, .object = name, .at = at(name) + Vec2{0.1, 0.4}, .to = {1, 3}}}};
        auto const first = computed(what);
        auto const second = computed(what);
        ASSERT_TRUE(first->firstDifference()) << name;
        EXPECT_GT(*first->firstDifference(), 40U);
        EXPECT_LE(*first->firstDifference(), 43U);
        EXPECT_EQ(first->firstDifference(), second->firstDifference());
        EXPECT_EQ(first->run().world().stateHash(), second->run().world().stateHash());
        EXPECT_NE(first->run().world().stateHash(), hash);
        EXPECT_TRUE(first->run().whyNotRecorded()) << "it counts as no solution";
    }
    EXPECT_EQ(world().stateHash(), hash) << "the real run is as it was";
    EXPECT_FALSE(session().altered());
}

TEST_F(OtherRunTest, PutsAnObjectWhereItIsTold) {
    open("2-doorbell.json");
    runTo(60);
    std::string name;
    for (ObjectId const id : world().store().findColumn<Velocity>()->owners()) {
        name = world().find<Fixed>(id) == nullptr ? world().store().nameOf(id) : name;
    }
    Vec2 const to = at(name) + Vec2{0.2, 1};
    auto const other = computed({60, {{.kind = Change::Kind::place, .object = name, .at = to}}});
    Stage stage([this] { return buildAgain(gameData().registry, session()); });
    stage.show(other->recording(), 60);
    EXPECT_EQ(stage.world().find<Position>(id(name))->value, to);
    EXPECT_TRUE(isElsewhere(world().store(), stage.world().store(), id(name)));
    EXPECT_FALSE(isElsewhere(world().store(), world().store(), id(name)));
}

TEST_F(OtherRunTest, LeavesAnInteractionOut) {
    open("1-switched-electromagnet.json");
    runTo(200);
    std::size_t different = 0;
    for (ComponentStatus const& status : world().status()) {
        if (status.info->kind != ComponentKind::interaction || status.activity == Activity::absent) {
            continue;
        }
        auto const other =
            computed({20, {{.kind = Change::Kind::interaction, .object = title(*status.info)}}});
        different += other->firstDifference() ? 1U : 0U;
        for (ComponentStatus const& left : other->run().world().status()) {
            if (title(*left.info) == title(*status.info)) {
                EXPECT_EQ(left.activity, Activity::absent) << title(*left.info);
            }
        }
    }
    EXPECT_GT(different, 1U) << "gravity and magnetism move something";
}

TEST_F(OtherRunTest, SetsWhatComponentsRead) {
    open("4-raft.json");
    runTo(90);
    ObjectId const cargo = id("cargo 1");
    std::vector<SettableField> const fields = settableFields(world(), cargo);
    auto const mass = std::find_if(fields.begin(), fields.end(), [](SettableField const& field) {
        return field.property->text.key == "mass";
    });
    ASSERT_NE(mass, fields.end());
    for (SettableField const& field : fields) {
        EXPECT_NE(field.property->text.key, "at") << "objects are moved";
    }
    auto const heavy = computed({30,
                                 {{.kind = Change::Kind::field,
                                   .object = "cargo 1",
                                   .property = "mass",
                                   .field = mass->key,
                                   .amount = {20 * mass->now.x, 0}}}});
    EXPECT_EQ(heavy->firstDifference(), 31U);
    auto const same = computed({30,
                                {{.kind = Change::Kind::field,
                                  .object = "cargo 1",
                                  .property = "mass",
                                  .field = mass->key,
                                  .amount = mass->now}}});
    EXPECT_FALSE(same->firstDifference());
}

TEST_F(OtherRunTest, LeavesOutAGrab) {
    open("4-raft.json");
    session().start();
    ObjectId const cargo = id("cargo 1");
    session().feed({PlayerInput::Kind::grab, cargo, {}, at("cargo 1")});
    for (int i = 0; i < 60; ++i) {
        session().feed({PlayerInput::Kind::move, cargo, {}, at("cargo 1") + Vec2{0.3, 0.5}});
        step();
    }
    session().feed({PlayerInput::Kind::release, cargo, {}, {}});
    runTo(100);
    auto const without = computed({0, {{.kind = Change::Kind::input, .index = 0}}});
    ASSERT_TRUE(without->firstDifference());
    open("4-raft.json");
    runTo(100);
    EXPECT_EQ(without->run().world().stateHash(), world().stateHash()) << "as if nobody had touched anything";
}

// A second player holds a box all the time; a grab of another one does not make them let go.
TEST_F(OtherRunTest, AGrabLeavesTheHandsOfPlayersAlone) {
    open("4-raft.json");
    session().start();
    using Kind = PlayerInput::Kind;
    Vec2 const held = at("cargo 4");
    session().feed({Kind::grab, id("cargo 4"), {}, held, 1});
    session().feed({Kind::move, id("cargo 4"), {}, held + Vec2{0, 0.3}, 1});
    runTo(150);
    auto const other = computed({60,
                                 {{.kind = Change::Kind::grab,
                                   .object = "cargo 13",
                                   .at = {3.8, -1},
                                   .to = {3.8, 0.5},
                                   .frames = 60}}});
    ASSERT_TRUE(other->firstDifference());
    EXPECT_LE(*other->firstDifference(), 63U);
    EXPECT_TRUE(other->paths().contains(id("cargo 13"))) << "it is pulled";
    EXPECT_FALSE(other->paths().contains(id("cargo 4"))) << "it is held, as in the real run";
    auto const* const second = other->run().world().find<SecondHand>();
    ASSERT_NE(second, nullptr);
    EXPECT_EQ(second->grip.object, id("cargo 4"));
    EXPECT_FALSE(other->run().world().find<Hand>()->object.valid()) << "it has let go";
}

TEST_F(OtherRunTest, GoesOnWithTheRealRun) {
    open("2-doorbell.json");
    runTo(50);
    OtherRun run(gameData().registry, session(), {20, {}});
    while (run.advance(7, 50)) {
    }
    runTo(80);
    while (run.advance(7, 80)) {
    }
    EXPECT_EQ(run.run().world().stateHash(), world().stateHash());
    EXPECT_FALSE(run.firstDifference());
}

} // namespace
} // namespace trembler::insight
