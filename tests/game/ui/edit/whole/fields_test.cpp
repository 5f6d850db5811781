// Fields of the editor's panel for optional parts of a level file: the second object of a joint, corners of
// an area, entries of lists, missing mods.
#include "puzzle/edit/commands/objects.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

namespace trembler::ui::test {
namespace fields_test {
namespace {

char const* const shapes = R"({"version": 2, "title": "Fields",
    "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4.5]},
    "objects": [
        {"name": "post", "at": [-2, 1], "properties": {"material": "wood", "fixed": true, "drawing": {"shapes": []},
         "shape": [{"form": "box", "width": 0.2, "height": 1}]}},
        {"name": "arm", "at": [-1.5, 1.4], "properties": {"material": "wood",
         "shape": [{"form": "box", "width": 1, "height": 0.1}]}}],
    "joints": [{"name": "pin", "form": "hinge", "a": "arm", "b": "post", "at": [-2, 1.4]}],
    "placing": [[[0, 0], [2, 0], [2, 2], [0, 2]]]})";

TEST(EditorFields, AJointMayHoldItsObjectToTheWorld) {
    Designer designer;
    designer.editText(shapes);
    designer.parts().selection.choose(EntryKind::joint, "/joints/0");
    designer.key(SDLK_F4);
    designer.frames(2);
    designer.seek("joint/b");
    designer.clickItem("joint/b");
    designer.frames(2);
    designer.clickItem("joint/b = ");
    designer.frames(2);
    EXPECT_FALSE(designer.tree()["joints"][0].contains("b"));
    EXPECT_EQ(designer.parts().selection.kind(), EntryKind::joint) << "it is still selected";
    designer.ctrl(SDLK_z);
    EXPECT_EQ(designer.tree()["joints"][0]["b"], "post");
}

TEST(EditorFields, AnAreaGainsAndLosesCorners) {
    Designer designer;
    designer.editText(shapes);
    designer.parts().selection.choose(EntryKind::placing, "/placing/0");
    designer.key(SDLK_F4);
    designer.frames(2);
    designer.seek("area add");
    designer.clickItem("area add");
    designer.frames(2);
    ASSERT_EQ(designer.tree()["placing"][0].size(), 5U);
    EXPECT_EQ(designer.tree()["placing"][0][4], edit::Json::array({0, 1}));
    designer.look("edit-corners");
    designer.seek("area 1 remove");
    designer.clickItem("area 1 remove");
    designer.frames(2);
    EXPECT_EQ(designer.tree()["placing"][0], edit::Json::parse("[[0, 0], [2, 2], [0, 2], [0, 1]]"));
    designer.ctrl(SDLK_z);
    EXPECT_EQ(designer.tree()["placing"][0].size(), 5U) << "each is a step of its own";
    designer.ctrl(SDLK_z);
    EXPECT_EQ(designer.tree()["placing"][0].size(), 4U);
}

TEST(EditorFields, AnEmptyListIsBegun) {
    Designer designer;
    designer.editText(shapes);
    designer.parts().selection.set({"post"});
    designer.key(SDLK_F4);
    designer.frames(2);
    designer.seek("add drawing/shapes");
    designer.clickItem("add drawing/shapes");
    designer.frames(2);
    auto const shapesOf = [&] {
        return (*edit::findObject(designer.tree(), "post"))["properties"]["drawing"]["shapes"];
    };
    EXPECT_EQ(shapesOf().size(), 1U);
    designer.look("edit-list");
    designer.ctrl(SDLK_z);
    EXPECT_EQ(shapesOf().size(), 0U);
}

TEST(EditorFields, SeveralObjectsAreChangedAtOnceInOneStep) {
    Designer designer;
    designer.editText(shapes);
    std::string const before = designer.parts().document.text();
    designer.parts().selection.set({"post", "arm"});
    designer.key(SDLK_F4);
    designer.frames(2);
    designer.seek("material");
    designer.clickItem("material");
    designer.frames(2);
    designer.clickItem("material = iron");
    designer.frames(2);
    for (char const* const name : {"post", "arm"}) {
        EXPECT_EQ((*edit::findObject(designer.tree(), name))["properties"]["material"], "iron") << name;
    }
    EXPECT_EQ(designer.parts().selected().size(), 2U) << "they are still selected";
    EXPECT_EQ(designer.parts().document.done(), 1U);
    designer.seek("at x");
    designer.drag(designer.item("at x"), designer.item("at x") + Point{40, 0});
    Vec2 const post = designer.placeOf("post");
    EXPECT_EQ(designer.placeOf("arm").x, post.x) << "where the values differed, both have the new one";
    EXPECT_EQ(designer.placeOf("arm").y, 1.4) << "each keeps its height";
    EXPECT_EQ(post.y, 1);
    EXPECT_EQ(designer.parts().document.done(), 2U);
    designer.ctrl(SDLK_z);
    designer.ctrl(SDLK_z);
    EXPECT_EQ(designer.parts().document.text(), before);
}

TEST(EditorFields, AModThatIsNowhereIsTakenOut) {
    Designer designer;
    designer.editText(R"({"version": 2, "title": "Modded", "mods": ["of yesterday"], "objects": []})");
    if (designer.parts().document.readOnly()) {
        designer.clickItem("edit nevertheless");
        designer.frames(2);
    }
    designer.key(SDLK_F6);
    designer.frames(2);
    designer.seek("mod of yesterday");
    designer.clickItem("mod of yesterday");
    designer.frames(2);
    EXPECT_FALSE(designer.tree().contains("mods"));
}

} // namespace
} // namespace fields_test
} // namespace trembler::ui::test
