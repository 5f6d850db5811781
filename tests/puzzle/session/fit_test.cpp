// Free places for parts: occupied by objects that can collide, not by objects that cannot.
#include "physics/dynamics/properties/body.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/level/read/read_part.hpp"
#include "tests/support/experiment.hpp"

#include <string>
#include <utility>

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

/// Parts of a player's own: a hub with a ring that meets rings only, held in one way or another.
class FitOfOwnRings : public Experiment {
protected:
    FitOfOwnRings() {
        add("sprung", R"({"form": "spring", "a": "ring", "b": "hub", "at": [0, 0], "at_b": [0, 0.1],
                         "stiffness": 60})");
        add("welded", R"({"form": "weld", "a": "ring", "b": "hub", "at": [0, 0]})");
        add("both", R"({"form": "weld", "a": "ring", "b": "hub", "at": [0, 0]},
                       {"form": "spring", "a": "ring", "b": "hub", "at": [0, 0], "at_b": [0, 0.1],
                        "stiffness": 60})");
        add("loose", "");
        parts.add(read(R"({"name": "ring in a case", "objects": [{"name": "inside", "part": "sprung"}]})"));
    }
    void add(std::string const& name, std::string const& joints) {
        parts.add(read(R"({"name": ")" + name + R"(", "main": "hub", "objects": [
            {"name": "hub", "properties": {"material": "steel", "fixed": true,
             "shape": [{"form": "circle", "radius": 0.1}]}},
            {"name": "ring", "properties": {"material": "copper", "shape": [{"form": "circle", "radius": 0.5}],
             "collision": {"category": 16384, "mask": 16384}}}], "joints": [)" +
                       joints + "]}"));
    }
    static PartDefinition read(std::string const& text) {
        return readPart(gameData().registry, JsonDocument::parse(text, "part.json"));
    }
    /// Whether the part may be put so close to another that their rings overlap by 20 cm.
    [[nodiscard]] bool fits(std::string const& part, std::string const& there) const {
        LevelFile level = readLevel(
            gameData().registry,
            JsonDocument::parse(
                R"({"version": 2, "title": "t", "objects": [{"name": "there", "at": [0, 0], "part": ")" +
                    there + R"("}], "toolbox": [{"part": ")" + part + R"(", "count": 1}]})",
                "level.json"));
        Session session(gameData().registry, parts, std::move(level));
        return session.check({part, {0.8, 0}, 0, ""}).ok;
    }

    PartLibrary parts = gameData().parts;
};

TEST_F(FitOfOwnRings, OverlapOnlyIfSpringsHoldBoth) {
    EXPECT_TRUE(fits("sprung", "sprung"));
    for (char const* const rigid : {"welded", "both", "loose"}) {
        EXPECT_FALSE(fits("sprung", rigid)) << rigid;
        EXPECT_FALSE(fits(rigid, "sprung")) << rigid;
        EXPECT_FALSE(fits(rigid, rigid)) << rigid;
    }
}

TEST_F(FitOfOwnRings, InsideAnotherPartAreKnownByTheJointsThere) {
    EXPECT_TRUE(fits("ring in a case", "sprung"));
    EXPECT_TRUE(fits("sprung", "ring in a case"));
    EXPECT_FALSE(fits("ring in a case", "welded"));
}

} // namespace
} // namespace trembler
