// Free places for parts: occupied by objects that can collide, not by objects that cannot.
#include "physics/dynamics/properties/body.hpp"
#include "tests/support/experiment.hpp"

namespace trembler {
namespace {

class Fit : public Experiment {};

TEST_F(Fit, IgnoresObjectsThatAreOnlyBehind) {
    open("2-doorbell.json");
    Vec2 const free{0.47, 1.96};
    EXPECT_TRUE(session().check({"wooden wedge", free, 0, ""}).ok) << "only the backboard is behind it";
    Verdict const onTheBell = session().check({"wooden wedge", at("bell"), 0, ""});
    EXPECT_FALSE(onTheBell.ok);
    EXPECT_NE(onTheBell.why.find("bell"), std::string::npos) << onTheBell.why;

    LevelFile solid = load("2-doorbell.json");
    for (LevelObject& object : solid.objects) {
        if (object.name == "backboard") {
            object.properties.set(CollisionGroups{});
        }
    }
    open(std::move(solid));
    EXPECT_FALSE(session().check({"wooden wedge", free, 0, ""}).ok) << "the board now collides with it";
}

} // namespace
} // namespace trembler
