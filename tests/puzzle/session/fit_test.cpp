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

TEST_F(Fit, LetsTheContactRingsOfCogsPressOnEachOther) {
    for (double const away : {-0.02, 0.0, 0.02}) {
        open("../first/7-turn-and-current.json");
        Verdict const between = session().check({"large cog", {-0.5 + away, 1.6}, 0, ""});
        EXPECT_TRUE(between.ok) << away << ": " << between.why;
    }
    Verdict const onTheTeeth = session().check({"large cog", {-0.6, 1.6}, 0, ""});
    EXPECT_FALSE(onTheTeeth.ok) << "teeth give no way";
    EXPECT_NE(onTheTeeth.why.find("driver"), std::string::npos) << onTheTeeth.why;
    EXPECT_FALSE(session().check({"copper bar", at("driver"), 0, ""}).ok);
}

} // namespace
} // namespace trembler
