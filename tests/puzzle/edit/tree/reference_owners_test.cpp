#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/tree/reference_owners.hpp"
#include "puzzle/edit/world/edited_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <set>

namespace trembler::edit {
namespace reference_owners_test {
namespace {

/// A cart "a", whose left wheel is "a left wheel" in the world, beside another, "a left", and a stone without
/// a part. Ropes, hinges and wires refer to all of them.
Json besideOneAnother() {
    return Json::parse(R"({
        "version": 2, "title": "carts",
        "objects": [
            {"name": "a", "part": "cart", "at": [0, 5]}, {"name": "a left", "part": "cart", "at": [4, 5]},
            {"name": "a left stone", "at": [8, 5],
             "properties": {"shape": [{"form": "box", "width": 0.5, "height": 0.5}], "density": 2000}},
            {"part": "cart"}, 3],
        "joints": [
            {"name": "pin", "form": "hinge", "a": "a left wheel", "at": [0, 5]},
            {"name": "a pin", "form": "hinge", "a": "a left left wheel", "at": [4, 5]},
            {"name": "line", "form": "rope", "a": "a bed", "b": "a left bed", "at": [0, 6], "at_b": [4, 6]},
            {"name": "rod", "form": "rope", "a": "a left wheel", "b": "a left stone", "at": [0, 5], "at_b": [8, 5]},
            {"name": "cogs", "form": "gear", "joint_a": "a left axle", "joint_b": "a left left axle"}],
        "connections": [["a left wheel", "a bed"], ["a left left wheel", "a left"], ["a left wheel", "a left stone"]]
        })");
}

Json after(Json level, Command const& command) {
    command.change(level);
    return level;
}

std::vector<std::string> namesOf(Json const& list) {
    std::vector<std::string> names;
    for (Json const& entry : list) {
        names.push_back(entry["name"]);
    }
    return names;
}

using Names = std::vector<std::string>;

TEST(ReferenceOwners, AreEntriesOrTheObjectsOfPieces) {
    ReferenceOwners const owners(editData(), besideOneAnother());
    EXPECT_EQ(owners.of("a"), "a");
    EXPECT_EQ(owners.of("a bed"), "a");
    EXPECT_EQ(owners.of("a left wheel"), "a") << "though there is an object 'a left' with a part";
    EXPECT_EQ(owners.of("a left axle"), "a") << "a joint of the part";
    EXPECT_EQ(owners.of("a left"), "a left");
    EXPECT_EQ(owners.of("a left left wheel"), "a left");
    EXPECT_EQ(owners.of("a left stone"), "a left stone");
    EXPECT_EQ(owners.of("a pin"), "a pin") << "a joint of the level";
    EXPECT_EQ(owners.of("a mast"), "a mast") << "the part has no such piece";
    EXPECT_EQ(owners.of("a left stone wheel"), "a left stone wheel") << "it is made from no part";
    EXPECT_EQ(owners.of(" bed"), " bed") << "of the object without a name";
    EXPECT_EQ(owners.of(""), "");
    EXPECT_EQ(ReferenceOwners(editData(), Json(3)).of("a bed"), "a bed");
}

TEST(ReferenceOwners, AreAmongNames) {
    ReferenceOwners const owners(editData(), besideOneAnother());
    std::set<std::string> const names{"a", "gone"};
    EXPECT_TRUE(owners.among(names, "a"));
    EXPECT_TRUE(owners.among(names, "a left wheel"));
    EXPECT_TRUE(owners.among(names, "gone")) << "as it is named";
    EXPECT_FALSE(owners.among(names, "a left"));
    EXPECT_FALSE(owners.among(names, "a left left wheel"));
}

// The world that is built from the level knows the entry of each of its objects without any names.
TEST(ReferenceOwners, AgreeWithTheWorld) {
    Json tree = besideOneAnother();
    tree["objects"].erase(4);
    tree["objects"].erase(3);
    tree.erase("joints"); // only objects have entries
    tree.erase("connections");
    ReferenceOwners const owners(editData(), tree);
    EditedWorld edited;
    edited.build(editData(), readLevel(editData().registry, JsonDocument::parse(tree.dump(), "level")), tree);
    ASSERT_EQ(edited.leftOut(), 0U);
    Store const& store = edited.world()->store();
    std::size_t checked = 0;
    for (std::uint32_t index = 0; index < store.objects().indexBound(); ++index) {
        ObjectId const id = store.objects().at(index);
        if (std::string const& entry = edited.entryOf(id); !entry.empty()) {
            EXPECT_EQ(owners.of(store.nameOf(id)), entry);
            ++checked;
        }
    }
    EXPECT_GE(checked, 7U);
}

TEST(ReferenceOwners, GoWithWhatIsRemoved) {
    Json const without = after(besideOneAnother(), removeObjects(editData(), besideOneAnother(), {"a left"}));
    EXPECT_EQ(namesOf(without["joints"]), (Names{"pin", "rod"}));
    EXPECT_EQ(without["connections"],
              Json::parse(R"([["a left wheel", "a bed"], ["a left wheel", "a left stone"]])"));
    Json const other = after(besideOneAnother(), removeObjects(editData(), besideOneAnother(), {"a"}));
    EXPECT_EQ(namesOf(other["joints"]), (Names{"a pin"}));
    EXPECT_EQ(other["connections"], Json::parse(R"([["a left left wheel", "a left"]])"));
}

TEST(ReferenceOwners, TakeJointsAlong) {
    Json const moved =
        after(besideOneAnother(), moveObjects(editData(), besideOneAnother(), {"a left"}, {0, 1}));
    Json const& joints = moved["joints"];
    EXPECT_EQ(joints[0]["at"], Json::array({0, 5})) << "the wheel of the other cart";
    EXPECT_EQ(joints[1]["at"], Json::array({4, 6}));
    EXPECT_EQ(joints[2]["at"], Json::array({0, 6}));
    EXPECT_EQ(joints[2]["at_b"], Json::array({4, 7}));
    EXPECT_EQ(joints[3], besideOneAnother()["joints"][3]);
    Json const turned =
        after(besideOneAnother(), rotateObjects(editData(), besideOneAnother(), {"a"}, 90, {0, 0}));
    EXPECT_EQ(turned["joints"][0]["at"], Json::array({-5, 0}));
    EXPECT_EQ(turned["joints"][1], besideOneAnother()["joints"][1]);
    EXPECT_EQ(turned["joints"][3]["at"], Json::array({-5, 0}));
    EXPECT_EQ(turned["joints"][3]["at_b"], Json::array({8, 5}));
}

TEST(ReferenceOwners, AreCopiedWithTheirJoints) {
    Json const copied =
        after(besideOneAnother(), duplicateObjects(editData(), besideOneAnother(), {"a"}, {0, 1}));
    ASSERT_EQ(copied["joints"].size(), 6U) << "only the pin is the cart's alone";
    EXPECT_EQ(copied["joints"][5]["a"], "a 2 left wheel");
    ASSERT_EQ(copied["connections"].size(), 4U);
    EXPECT_EQ(copied["connections"][3], Json::array({"a 2 left wheel", "a 2 bed"}));
    Json const other =
        after(besideOneAnother(), duplicateObjects(editData(), besideOneAnother(), {"a left"}, {0, 1}));
    ASSERT_EQ(other["joints"].size(), 6U);
    EXPECT_EQ(other["joints"][5]["a"], "a left 2 left wheel");
    ASSERT_EQ(other["connections"].size(), 4U);
    EXPECT_EQ(other["connections"][3], Json::array({"a left 2 left wheel", "a left 2"}));
}

TEST(ReferenceOwners, KeepTheirNamesWhenAnotherIsRenamed) {
    Json const first =
        after(besideOneAnother(), renameObject(editData(), besideOneAnother(), "a left", "truck"));
    EXPECT_EQ(first["joints"][0], besideOneAnother()["joints"][0]);
    EXPECT_EQ(first["joints"][1]["a"], "truck left wheel");
    EXPECT_EQ(first["joints"][2]["a"], "a bed");
    EXPECT_EQ(first["joints"][2]["b"], "truck bed");
    EXPECT_EQ(first["joints"][3], besideOneAnother()["joints"][3]);
    EXPECT_EQ(first["joints"][4]["joint_a"], "a left axle");
    EXPECT_EQ(first["joints"][4]["joint_b"], "truck left axle");
    Json const second = after(besideOneAnother(), renameObject(editData(), besideOneAnother(), "a", "truck"));
    EXPECT_EQ(second["joints"][0]["a"], "truck left wheel");
    EXPECT_EQ(second["joints"][1], besideOneAnother()["joints"][1]);
    EXPECT_EQ(second["joints"][3]["b"], "a left stone");
    EXPECT_EQ(second["connections"][2], Json::array({"truck left wheel", "a left stone"}));
}

} // namespace
} // namespace reference_owners_test
} // namespace trembler::edit
