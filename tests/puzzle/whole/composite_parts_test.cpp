// Composite parts in a session: placed, moved, flipped, recorded and judged like any other part.
#include "puzzle/solutions/verify.hpp"
#include "runtime/level/read/solutions/read_solutions.hpp"
#include "runtime/level/write/write_level.hpp"
#include "runtime/placement.hpp"
#include "tests/puzzle/whole/swing.hpp"

#include <algorithm>

namespace trembler {
namespace {

class CompositeParts : public WithSwing {
protected:
    static constexpr char const* toolbox =
        R"(, "toolbox": [{"part": "swing", "count": 2}, {"part": "steel ball", "count": 3}])";
    static Placement swing(double x, double y = 1) { return {"swing", {x, y}, 0, ""}; }
    static Vec2 place(Session const& session, std::string const& name) {
        Position const* const position = session.world().find<Position>(session.world().store().find(name));
        return position == nullptr ? Vec2{NAN, NAN} : position->value;
    }
};

TEST_F(CompositeParts, ArePlacedAsAllTheirPieces) {
    auto const session = open(level("", toolbox));
    std::optional<int> const number = session->place(swing(2));
    ASSERT_TRUE(number);
    Store const& store = session->world().store();
    EXPECT_EQ(session->objectsOf(*number).size(), 5U);
    EXPECT_EQ(session->objectOf(*number), store.find("swing 1 arm"));
    EXPECT_EQ(store.find("swing 1"), store.find("swing 1 arm"));
    for (char const* const piece : {"arm", "post", "slide", "joint 1", "joint 2"}) {
        ObjectId const id = store.find(std::string("swing 1 ") + piece);
        ASSERT_TRUE(id.valid()) << piece;
        EXPECT_EQ(session->numberOf(id), number) << piece;
        EXPECT_EQ(session->find(session->lasting(id)), id) << piece;
    }
    EXPECT_EQ(session->toolbox()[0].left, 1);
    EXPECT_NEAR(place(*session, "swing 1 arm").x, 2.3, 1e-12);

    ASSERT_TRUE(session->place(swing(-2)));
    LastingObject const post = session->lasting(session->world().store().find("swing 2 post"));
    ASSERT_TRUE(session->putBack(*session->numberOf(session->world().store().find("swing 1 post"))));
    EXPECT_EQ(session->world().store().nameOf(session->find(post)), "swing 1 post")
        << "the same one, renamed";
    EXPECT_FALSE(session->place(swing(20)) && session->place(swing(-20))) << "the toolbox has two";
}

TEST_F(CompositeParts, MoveTurnAndFlipAsOne) {
    auto const session = open(level("", toolbox));
    int const number = *session->place(swing(2));
    std::uint64_t const first = hashAfter(*session, 30);
    ASSERT_TRUE(session->move(number, {2.01, 1}, 0)) << "its own pieces are not in its way";
    ASSERT_TRUE(session->move(number, {3, 2}, pi / 2));
    EXPECT_NEAR(place(*session, "swing 1 arm").x, 3 - 0.6, 1e-12);
    EXPECT_NEAR(place(*session, "swing 1 arm").y, 2 + 0.3, 1e-12);
    ASSERT_TRUE(session->flip(number));
    EXPECT_NEAR(place(*session, "swing 1 arm").y, 2 - 0.3, 1e-12) << "mirrored, then turned";
    EXPECT_TRUE(session->placed()[0].placement.flipped);
    ASSERT_TRUE(session->undo() && session->undo() && session->undo());
    EXPECT_EQ(hashAfter(*session, 30), first);
    ASSERT_TRUE(session->flip(number));
    EXPECT_NE(hashAfter(*session, 30), first);
    ASSERT_TRUE(session->flip(number));
    EXPECT_EQ(hashAfter(*session, 30), first) << "flipped twice";
    EXPECT_TRUE(session->putBack(number));
    EXPECT_FALSE(session->world().store().find("swing 1").valid());
    EXPECT_FALSE(session->flip(number));
    EXPECT_TRUE(session->undo());
    EXPECT_EQ(hashAfter(*session, 30), first);
}

TEST_F(CompositeParts, FitOnlyIfAllTheirPiecesDo) {
    auto const session = open(level("", toolbox));
    ASSERT_TRUE(session->place({"steel ball", {-0.5, 1.4}, 0, ""}));
    Verdict const onTheSlide = session->check(swing(0));
    EXPECT_FALSE(onTheSlide.ok) << "its slide is there";
    EXPECT_NE(onTheSlide.why.find("steel ball 1"), std::string::npos) << onTheSlide.why;
    Placement flipped = swing(0);
    flipped.flipped = true;
    EXPECT_TRUE(session->check(flipped).ok) << "its slide is on the other side";
    ASSERT_TRUE(session->place(flipped));
    EXPECT_FALSE(session->check({"steel ball", {0, 1}, 0, ""}).ok) << "the post is no main piece, but solid";
    EXPECT_FALSE(session->flip(session->placed()[1].number)) << "the ball is in the way";
}

TEST_F(CompositeParts, TheOrderOfPlacingNeverMatters) {
    auto const a = open(level("", toolbox));
    auto const b = open(level("", toolbox));
    Placement mirrored = swing(-2);
    mirrored.flipped = true;
    ASSERT_TRUE(a->place(swing(2)) && a->place(mirrored) && a->place({"steel ball", {2.4, 3}, 0, ""}));
    ASSERT_TRUE(b->place({"steel ball", {2.4, 3}, 0, ""}) && b->place(mirrored) && b->place(swing(2)));
    EXPECT_EQ(hashAfter(*a, 90), hashAfter(*b, 90));
}

TEST_F(CompositeParts, SolutionsAreRecordedAndRepeated) {
    auto const session = open(level("", toolbox));
    Placement mirrored = swing(-2);
    mirrored.flipped = true;
    ASSERT_TRUE(session->place(mirrored));
    session->start();
    ObjectId const arm = session->world().store().find("swing 1 arm");
    session->feed({PlayerInput::Kind::grab, arm, {}, place(*session, "swing 1 arm")});
    session->step();
    session->feed({PlayerInput::Kind::move, {}, {}, {-2, 3}});
    for (int i = 0; i < 30; ++i) {
        session->step();
    }
    std::uint64_t const hash = session->world().stateHash();
    nlohmann::ordered_json const written = writeSolution(session->record("mine"));
    EXPECT_EQ(written["placements"][0]["flipped"], true);
    EXPECT_EQ(written["inputs"][0]["grab"], "swing 1 arm");

    nlohmann::ordered_json file = writeLevel(level("", toolbox));
    file["solutions"].push_back(written);
    auto const fromFile = [&] {
        return open(readLevel(gameData().registry, JsonDocument::parse(file.dump(), "level.json")));
    };
    auto const again = fromFile();
    again->load(again->level().solutions[0]);
    for (int i = 0; i < 31; ++i) {
        again->step();
    }
    EXPECT_EQ(again->world().stateHash(), hash);

    file["solutions"][0]["inputs"][0]["grab"] = "swing 1 leg"; // found only when a world is built
    auto const wrong = fromFile();
    try {
        wrong->load(wrong->level().solutions[0]);
        FAIL() << "must be refused";
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("there is no object 'swing 1 leg'"), std::string::npos)
            << error.what();
    }
    file["solutions"][0]["inputs"][0]["grab"] = "swin 1 arm";
    EXPECT_THROW(static_cast<void>(fromFile()), InputError) << "that cannot be a piece";
}

TEST_F(CompositeParts, TheirWiresCanBeCut) {
    parts.add(part(R"({"name": "lead", "objects": [{"name": "a", "part": "copper contact"},
        {"name": "b", "part": "copper contact", "at": [1, 0]},
        {"name": "c", "part": "copper contact", "at": [2, 0]}], "connections": [["a", "b"]]})"));
    auto const problem = [&](std::string const& cuts) -> std::string {
        try {
            auto const session = open(level(R"({"name": "left", "part": "lead", "at": [0, 2]})",
                                            R"(, "solutions": [{"name": "s", "inputs": [)" + cuts + "]}]"));
            session->load(session->level().solutions[0]);
            return "";
        } catch (InputError const& error) {
            return error.what();
        }
    };
    EXPECT_EQ(problem(R"({"frame": 1, "cut": ["left b", "left a"]})"), "");
    EXPECT_EQ(problem(R"({"frame": 1, "cut": ["left", "left b"]})"), "") << "its main piece";
    EXPECT_NE(problem(R"({"frame": 1, "cut": ["left b", "left c"]})").find("there is no wire between"),
              std::string::npos);
    EXPECT_NE(problem(R"({"frame": 1, "cut": ["left", "left b"]}, {"frame": 2, "cut": ["left a", "left b"]})")
                  .find("/solutions/0/inputs/1: the wire between 'left a' and 'left b' has been cut before"),
              std::string::npos);
}

TEST_F(CompositeParts, GoalsMeanTheirMainPieces) {
    std::string const objects = R"({"name": "left", "part": "swing", "at": [-2, 1]})";
    auto const goals = [&](std::string const& condition) {
        return open(level(objects, std::string(toolbox) + R"(, "goals": )" + condition));
    };
    std::string const where = R"({"inside": {"object": "it", "area": [-1.8, 1.5, 0.2, 0.2]}})";
    auto const counted =
        goals(R"({"count": {"of": {"part": "swing"}, "at_least": 1, "that": )" + where + "}}");
    counted->step();
    EXPECT_TRUE(counted->solved()) << "the arm is there, though neither the post nor the slide";
    auto const named = goals(R"({"inside": {"object": "left post", "area": [-2.1, 0.9, 0.2, 0.2]}})");
    named->step();
    EXPECT_TRUE(named->solved());
    try {
        static_cast<void>(goals(R"({"touching": ["left pos", "earth"]})"));
        FAIL() << "must be refused";
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("/goals/touching/0: there is no object 'left pos'"),
                  std::string::npos)
            << error.what();
    }
}

} // namespace
} // namespace trembler
