#include "game/ui/panels/inspector.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace {

TEST(Inspector, KeepsShowingAPartThatGetsAnothersName) {
    Session session(gameData().registry, gameData().parts,
                    readLevel(gameData().registry, JsonDocument::parse(R"({"version": 2, "title": "balls",
            "objects": [], "toolbox": [{"part": "steel ball", "count": 2}]})",
                                                                       "balls.json")));
    auto const first = session.place({"steel ball", {-3, 3}, 0, ""});
    auto const second = session.place({"steel ball", {3, 3}, 0, ""});
    ASSERT_TRUE(first && second);
    Inspector inspector;
    inspector.show(session, session.objectOf(*second));
    EXPECT_TRUE(inspector.open());
    EXPECT_EQ(inspector.name(), session.world().store().nameOf(session.objectOf(*second)));
    ASSERT_TRUE(session.putBack(*first));
    EXPECT_EQ(inspector.object(session), session.objectOf(*second));
    EXPECT_EQ(session.world().find<Position>(inspector.object(session))->value.x, 3);
    ASSERT_TRUE(session.putBack(*second));
    EXPECT_TRUE(inspector.open());
    EXPECT_FALSE(inspector.object(session).valid()) << "the card reports that the object was removed";
    inspector.show(session, {});
    EXPECT_FALSE(inspector.open());
}

} // namespace
} // namespace trembler::ui::test
