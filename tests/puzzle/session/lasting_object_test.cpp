// An object is found again although placements change the names and ids of others.
#include "puzzle/session/lasting_object.hpp"
#include "runtime/placement.hpp"
#include "tests/support/experiment.hpp"

namespace trembler {
namespace {

class LastingObjectTest : public Experiment {
protected:
    LastingObjectTest()
        : session(gameData().registry, gameData().parts,
                  readLevel(gameData().registry, JsonDocument::parse(R"({"version": 2, "title": "two balls",
            "objects": [{"name": "floor", "at": [0, -1], "properties":
                         {"shape": [{"form": "box", "width": 20, "height": 1}], "fixed": true}},
                        {"name": "arm", "at": [8, 5], "properties":
                         {"shape": [{"form": "box", "width": 1, "height": 0.2}]}}],
            "joints": [{"name": "pin", "form": "hinge", "a": "arm", "at": [8, 5]}],
            "toolbox": [{"part": "steel ball", "count": 3}]})",
                                                                     "two-balls.json"))) {}

    [[nodiscard]] double placeOf(LastingObject const& object) const {
        ObjectId const id = session.find(object);
        return id.valid() ? session.world().find<Position>(id)->value.x : -100;
    }
    [[nodiscard]] std::string nameOf(ObjectId id) const { return session.world().store().nameOf(id); }

    Session session;
};

TEST_F(LastingObjectTest, IsThePlacedPartAlsoAfterItsNameChanges) {
    auto const first = session.place({"steel ball", {-3, 3}, 0, ""});
    auto const second = session.place({"steel ball", {3, 3}, 0, ""});
    ASSERT_TRUE(first && second);
    LastingObject const meant = session.lasting(session.objectOf(*second));
    std::string const before = nameOf(session.find(meant));
    ASSERT_TRUE(session.putBack(*first));
    EXPECT_EQ(placeOf(meant), 3);
    EXPECT_NE(nameOf(session.find(meant)), before) << "otherwise this tests nothing";
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(placeOf(meant), 3);
    EXPECT_EQ(nameOf(session.find(meant)), before);
    ASSERT_TRUE(session.putBack(*second));
    EXPECT_FALSE(session.find(meant).valid()) << "it is back in the toolbox";
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(placeOf(meant), 3);
}

TEST_F(LastingObjectTest, IsTheSameInEveryRunAndInvalidAfterItsRemoval) {
    auto const ball = session.place({"steel ball", {3, 3}, 0, ""});
    ASSERT_TRUE(ball);
    LastingObject const meant = session.lasting(session.objectOf(*ball));
    LastingObject const floor = session.lasting(session.world().store().find("floor"));
    session.start();
    session.step();
    EXPECT_EQ(session.find(meant), session.objectOf(*ball));
    session.feed({PlayerInput::Kind::remove, session.objectOf(*ball), {}, {}});
    session.step();
    session.step();
    EXPECT_FALSE(session.find(meant).valid());
    EXPECT_EQ(nameOf(session.find(floor)), "floor");
    session.stop();
    EXPECT_EQ(placeOf(meant), 3);
}

TEST_F(LastingObjectTest, IsAnEntryOfTheLevel) {
    for (char const* name : {"floor", "pin", "world"}) {
        ObjectId const id = session.world().store().find(name);
        ASSERT_TRUE(id.valid()) << name;
        LastingObject const meant = session.lasting(id);
        ASSERT_TRUE(session.place({"steel ball", {0, 3}, 0, ""}));
        EXPECT_EQ(nameOf(session.find(meant)), name);
        ASSERT_TRUE(session.putAllBack());
    }
}

TEST_F(LastingObjectTest, OfAnInvalidIdIsInvalid) {
    EXPECT_EQ(session.lasting({}), LastingObject{});
    EXPECT_FALSE(session.find(LastingObject{}).valid());
}

} // namespace
} // namespace trembler
