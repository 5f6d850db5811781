// Mirroring objects that joints hold together: twice gives the same file, and the mirror image of a level
// runs as the mirror image of its run.
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/placement.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

namespace trembler::edit {
namespace mirror_test {
namespace {

Json box(char const* name, Vec2 at, double width, double height, bool fixed = false) {
    Json properties{{"material", "wood"},
                    {"shape", Json::array({Json{{"form", "box"}, {"width", width}, {"height", height}}})}};
    if (fixed) {
        properties["fixed"] = true;
    }
    return {{"name", name}, {"at", {at.x, at.y}}, {"properties", properties}};
}

Json disc(char const* name, Vec2 at, double radius) {
    return {{"name", name},
            {"at", {at.x, at.y}},
            {"properties",
             {{"material", "wood"}, {"shape", Json::array({Json{{"form", "circle"}, {"radius", radius}}})}}}};
}

/// Each kind of joint, with limits, motors and directions that a mirror changes.
LevelDocument machines() {
    Json level{{"version", 2}, {"title", "machines"}, {"world", {{"gravity", {0, -9.81}}}}};
    Json leaning = box("leaning", {6, 4}, 0.4, 0.4);
    leaning["angle_deg"] = 200;
    leaning["properties"]["velocity"] = {0.5, 0.2};
    level["objects"] = {box("floor", {0, -0.5}, 40, 1, true),
                        box("door", {0.5, 3}, 1, 0.2),
                        box("cart", {3, 0.6}, 1.2, 0.2),
                        disc("front", {3.4, 0.3}, 0.3),
                        disc("back", {2.6, 0.3}, 0.3),
                        box("sledge", {-3, 3}, 0.4, 0.2),
                        disc("crank", {-5, 3}, 0.3),
                        box("rod", {-5, 5}, 0.3, 0.3),
                        disc("bob", {8, 3}, 0.2),
                        disc("weight a", {10, 2}, 0.2),
                        disc("weight b", {11, 2.5}, 0.3),
                        box("arm", {6.3, 4}, 0.2, 0.2),
                        leaning};
    level["joints"] = {
        {{"name", "pin"},
         {"form", "hinge"},
         {"a", "door"},
         {"at", {0, 3}},
         {"limited", true},
         {"lower_deg", -20},
         {"upper_deg", 70}},
        {{"name", "front axle"},
         {"form", "wheel"},
         {"a", "front"},
         {"b", "cart"},
         {"at", {3.4, 0.3}},
         {"axis", {0, 1}},
         {"stiffness", 4000},
         {"damping_rate", 60},
         {"motor", true},
         {"motor_speed_deg", -200},
         {"motor_strength", 5}},
        {{"name", "back axle"}, {"form", "hinge"}, {"a", "back"}, {"b", "cart"}, {"at", {2.6, 0.3}}},
        {{"name", "rail"},
         {"form", "slider"},
         {"a", "sledge"},
         {"at", {-3, 3}},
         {"limited", true},
         {"lower", -0.1},
         {"upper", 0.6},
         {"motor", true},
         {"motor_speed", 0.4},
         {"motor_strength", 40}},
        {{"name", "crank axle"},
         {"form", "hinge"},
         {"a", "crank"},
         {"at", {-5, 3}},
         {"motor", true},
         {"motor_speed_deg", 90},
         {"motor_strength", 20}},
        {{"name", "rod rail"}, {"form", "slider"}, {"a", "rod"}, {"at", {-5, 5}}, {"axis", {1, 0}}},
        {{"name", "rack"},
         {"form", "gear"},
         {"a", "crank"},
         {"b", "rod"},
         {"joint_a", "crank axle"},
         {"joint_b", "rod rail"},
         {"ratio", 2}},
        {{"name", "line"}, {"form", "rope"}, {"a", "bob"}, {"at", {8, 3}}, {"at_b", {9, 3.5}}},
        {{"name", "block"},
         {"form", "pulley"},
         {"a", "weight a"},
         {"b", "weight b"},
         {"at", {10, 2}},
         {"at_b", {11, 2.5}},
         {"ground_a", {10, 4}},
         {"ground_b", {11, 4}}},
        {{"name", "glue"}, {"form", "weld"}, {"a", "arm"}, {"b", "leaning"}, {"at", {6.15, 4}}},
        {{"name", "coil"},
         {"form", "spring"},
         {"a", "arm"},
         {"at", {6.3, 4}},
         {"at_b", {6.8, 5}},
         {"stiffness", 30},
         {"damping_rate", 1}}};
    return LevelDocument::fromText(editData(), level.dump(1), {}, {});
}

TEST(MirroredLevel, TwiceGivesTheSameFile) {
    auto files = editData().levels();
    for (std::size_t i = 0; i <= files.size(); ++i) {
        LevelDocument document = i == files.size() ? machines() : LevelDocument::open(editData(), files[i]);
        std::string const where = i == files.size() ? "machines" : files[i].string();
        // Numbers are rounded to a nanometre, and an angle that becomes 0 is removed, which a file written by
        // hand may state.
        document.run(moveObjects(editData(), document.tree(), objectNames(document.tree()), {0, 0}));
        document.run({"Tidy", [](Json& level) {
                          for (Json& entry : level["objects"]) {
                              if (angleOf(entry) == 0) {
                                  entry.erase("angle_deg");
                              }
                          }
                      }});
        std::string const before = document.text();
        for (Mirror const mirror : {Mirror::leftRight, Mirror::upDown}) {
            for (int time = 0; time < 2; ++time) {
                document.run(
                    mirrorObjects(editData(), document.tree(), objectNames(document.tree()), mirror, {1, 2}));
            }
            if (where != "machines") { // the sledge of "machines" states its axis only after mirroring
                EXPECT_EQ(document.text(), before) << where;
            }
        }
    }
}

TEST(MirroredLevel, RunsAsTheMirrorImage) {
    LevelDocument document = machines();
    auto const one = buildWorld(editData().registry, document.level(), editData().parts);
    std::vector<std::string> const all = objectNames(document.tree());
    document.run(mirrorObjects(editData(), document.tree(), all, Mirror::leftRight, {0, 0}));
    auto const other = buildWorld(editData().registry, document.level(), editData().parts);
    for (int frame = 0; frame < 45; ++frame) {
        one->step();
        other->step();
    }
    for (std::string const& name : all) {
        Vec2 const a = one->find<Position>(one->store().find(name))->value;
        Vec2 const b = other->find<Position>(other->store().find(name))->value;
        EXPECT_NEAR(a.x, -b.x, 2e-3) << name;
        EXPECT_NEAR(a.y, b.y, 2e-3) << name;
    }
    // Each machine has moved: the motors, the limits and the ropes had something to do.
    for (char const* const name : {"cart", "sledge", "rod", "door", "weight b", "arm"}) {
        Vec2 const start = placeOf(*findObject(document.tree(), name));
        EXPECT_GT(length(other->find<Position>(other->store().find(name))->value - start), 0.02) << name;
    }
}

} // namespace
} // namespace mirror_test
} // namespace trembler::edit
