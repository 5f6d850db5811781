// A session: edits that cannot be built, overlapping parts, and the inputs of each run.
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/register_physics.hpp"
#include "runtime/level/read/read_part.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/registry.hpp"
#include "tests/support/experiment.hpp"

#include <cstdint>
#include <set>
#include <vector>

namespace trembler {
namespace {

class SessionTest : public Experiment {
protected:
    /// A pond, balls, and a puddle in the toolbox: if the puddle is placed on the pond, it collides with no
    /// solid object, but a rule of liquids forbids it, so no world can be built.
    SessionTest() {
        parts.add(readPart(gameData().registry, JsonDocument::parse(R"({"name": "puddle", "properties": {
            "material": "water", "shape": [{"form": "box", "width": 1, "height": 1}],
            "liquid": {"linear_drag": 1, "quadratic_drag": 1}}})",
                                                                    "puddle.json")));
        LevelFile level =
            readLevel(gameData().registry, JsonDocument::parse(R"({"version": 2, "title": "pond",
            "objects": [{"name": "pond", "at": [0, 0], "properties": {"material": "water",
                         "shape": [{"form": "box", "width": 4, "height": 2}],
                         "liquid": {"linear_drag": 1, "quadratic_drag": 1}}}],
            "toolbox": [{"part": "puddle", "count": 2}, {"part": "steel ball", "count": 3}]})",
                                                               "pond.json"));
        pond = std::make_unique<Session>(gameData().registry, parts, std::move(level));
    }
    static Placement ball(double x) { return {"steel ball", {x, 3}, 0, ""}; }
    static Placement puddle(double x) { return {"puddle", {x, 0}, 0, ""}; }

    PartLibrary parts = gameData().parts;
    std::unique_ptr<Session> pond;
};

TEST_F(SessionTest, AnEditThatCannotBeBuiltLeavesNoTrace) {
    ASSERT_TRUE(pond->place(puddle(5))) << "beside the pond";
    ASSERT_TRUE(pond->putAllBack());
    auto const a = pond->place(ball(-1));
    auto const b = pond->place(ball(1));
    ASSERT_TRUE(a && b);
    ASSERT_TRUE(pond->undo());
    std::uint64_t const hash = pond->world().stateHash();
    ASSERT_TRUE(pond->check(puddle(1)).ok) << "nothing solid is in its way";
    EXPECT_FALSE(pond->place(puddle(1)));
    ASSERT_EQ(pond->placed().size(), 1U);
    EXPECT_EQ(pond->placed()[0].number, *a);
    EXPECT_EQ(pond->world().stateHash(), hash);
    ASSERT_TRUE(pond->canRedo()) << "the undone edit can still be redone";
    EXPECT_TRUE(pond->redo());
    ASSERT_EQ(pond->placed().size(), 2U);
    EXPECT_EQ(pond->placed()[1].number, *b);
    EXPECT_FALSE(pond->canRedo()) << "an edit that cannot be built cannot be redone";

    auto const puddleBeside = pond->place(puddle(5));
    ASSERT_TRUE(puddleBeside);
    EXPECT_FALSE(pond->move(*puddleBeside, {2, 0}, 0));
    EXPECT_EQ(pond->world().find<Position>(pond->objectOf(*puddleBeside))->value, (Vec2{5, 0}));
    EXPECT_FALSE(pond->canRedo());

    Solution bad;
    bad.placements = {puddle(0.5)};
    EXPECT_THROW(pond->load(bad), InputError);
    EXPECT_EQ(pond->placed().size(), 3U);
    EXPECT_TRUE(pond->undo());
    EXPECT_EQ(pond->placed().size(), 2U) << "the previous edit is the puddle's";
}

TEST_F(SessionTest, TwoPartsInOnePlaceAreTwoObjects) {
    Solution solution;
    solution.placements = {ball(2), ball(-1), ball(2)};
    pond->load(solution);
    ASSERT_EQ(pond->placed().size(), 3U);
    for (PlacedPart const& part : pond->placed()) {
        ObjectId const object = pond->objectOf(part.number);
        EXPECT_EQ(pond->numberOf(object), part.number);
        EXPECT_EQ(pond->world().find<Position>(object)->value, part.placement.at);
    }
    int const first = pond->placed()[0].number;
    int const third = pond->placed()[2].number;
    EXPECT_NE(pond->objectOf(first), pond->objectOf(third));
    // Each can be removed and moved separately.
    ASSERT_TRUE(pond->move(third, {3, 3}, 0));
    EXPECT_EQ(pond->world().find<Position>(pond->objectOf(first))->value, (Vec2{2, 3}));
    EXPECT_EQ(pond->world().find<Position>(pond->objectOf(third))->value, (Vec2{3, 3}));
    EXPECT_FALSE(pond->objectOf(1000).valid());
    EXPECT_FALSE(pond->numberOf(pond->world().store().find("pond")));
}

TEST_F(SessionTest, AReplayReplacesTheInputsOfTheSolution) {
    open("2-doorbell.json", "hit the bell with the switch");
    runTo(60);
    std::uint64_t const hash = world().stateHash();
    std::size_t const inputs = session().inputs().size();
    ASSERT_EQ(inputs, 4U);
    Playback const done = session().done();
    session().startAgain();
    session().play(done);
    EXPECT_TRUE(session().playing());
    runTo(60);
    EXPECT_EQ(session().inputs().size(), inputs) << "each input once, although the solution has it as well";
    EXPECT_EQ(world().stateHash(), hash);
    // For that run only: the next one repeats the solution again.
    session().startAgain();
    EXPECT_FALSE(session().playing());
    session().play({});
    runTo(10);
    EXPECT_TRUE(session().inputs().empty()) << "without a solution there are no inputs";
    session().stop();
    EXPECT_FALSE(session().playing());
    session().play(done);
    EXPECT_FALSE(session().playing()) << "there is no run";
    runTo(60);
    EXPECT_EQ(session().inputs().size(), inputs);
    EXPECT_EQ(world().stateHash(), hash);
}

TEST_F(SessionTest, ASolutionIsFedUntilThePlacementsChange) {
    open("1-switched-electromagnet.json", "a spanner in its place");
    EXPECT_EQ(session().placed().size(), 1U);
    auto const fed = [&] {
        runTo(300);
        std::size_t const count = session().inputs().size();
        session().stop();
        return count;
    };
    EXPECT_EQ(fed(), 1U);
    EXPECT_EQ(fed(), 1U) << "in every run";
    ASSERT_TRUE(session().undo());
    EXPECT_TRUE(session().placed().empty());
    EXPECT_EQ(fed(), 0U) << "the placements differ from the solution's";
}

TEST_F(SessionTest, TheLogOfAnEndedRunIsKept) {
    open("4-raft.json");
    EXPECT_EQ(session().mode(), SessionMode::building);
    session().start();
    session().feed({PlayerInput::Kind::grab, id("cargo 1"), {}, {0, 0}});
    step();
    EXPECT_EQ(session().mode(), SessionMode::running);
    session().pause();
    EXPECT_EQ(session().mode(), SessionMode::paused);
    EXPECT_FALSE(session().place({"iron ball", {2, 1.5}, 0, ""})) << "while it runs";
    session().resume();
    EXPECT_EQ(session().mode(), SessionMode::running);
    EXPECT_EQ(session().record("r").inputs.size(), 1U);
    session().pause();
    session().stop();
    EXPECT_EQ(session().mode(), SessionMode::building);
    EXPECT_TRUE(session().inputs().empty());
    EXPECT_TRUE(session().record("r").inputs.empty());
    EXPECT_FALSE(session().record("r").frames);
    step();
    EXPECT_EQ(session().mode(), SessionMode::running) << "a run is not paused when it begins";
}

// Each state is built again, three thousand in all: in a world without effects, which takes a tenth of the
// time.
TEST(SessionUndo, GoesBackAThousandChangesAndForwardAgain) {
    Registry registry;
    registerEverything(registry, dispensableEffects());
    PartLibrary parts;
    parts.add(readPart(registry, JsonDocument::parse(R"({"name": "ball", "properties": {
        "material": "wood", "shape": [{"form": "circle", "radius": 0.1}]}})",
                                                     "ball.json")));
    Session session(registry, parts,
                    readLevel(registry, JsonDocument::parse(R"({"version": 2, "title": "ball", "objects": [],
                        "toolbox": [{"part": "ball"}]})",
                                                            "ball-level.json")));
    auto const ball = session.place({"ball", {0, 3}, 0, ""});
    ASSERT_TRUE(ball);
    std::vector<std::uint64_t> states;
    std::size_t const changes = Session::mostUndo + 3;
    for (std::size_t i = 0; i < changes; ++i) {
        ASSERT_TRUE(session.move(*ball, {0.01 * static_cast<double>(i), 3}, 0));
        states.push_back(session.world().stateHash());
    }
    ASSERT_EQ(std::set<std::uint64_t>(states.begin(), states.end()).size(), changes) << "all differ";
    std::size_t at = changes - 1;
    while (session.undo()) {
        ASSERT_GT(at, 0U);
        ASSERT_EQ(session.world().stateHash(), states[--at]) << "back to change " << at;
    }
    EXPECT_EQ(changes - 1 - at, Session::mostUndo);
    EXPECT_EQ(session.placed().size(), 1U) << "its placing is forgotten";
    while (session.redo()) {
        ASSERT_LT(at + 1, changes);
        ASSERT_EQ(session.world().stateHash(), states[++at]) << "forward to change " << at;
    }
    EXPECT_EQ(at, changes - 1);
}

} // namespace
} // namespace trembler
