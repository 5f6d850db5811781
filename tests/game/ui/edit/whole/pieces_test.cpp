// Pieces of composite parts are selected and changed in the editor, with real input events.
#include "game/ui/edit/view/edit_geometry.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/commands/properties.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

namespace trembler::ui::test {
namespace pieces_test {
namespace {

char const* const bells = R"({"version": 2, "title": "Bells",
    "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4.5]},
    "objects": [
        {"name": "floor", "at": [0, -0.15], "properties": {"material": "stone", "fixed": true,
         "shape": [{"form": "box", "width": 7.6, "height": 0.3}]}},
        {"name": "front bell", "part": "doorbell", "at": [-2, 2]},
        {"name": "back bell", "part": "doorbell", "at": [0.5, 2]}],
    "goals": {"moved": {"object": "front bell striker", "by": 1}}})";

/// On the arm of the striker of the front bell.
constexpr Vec2 onStriker{-2.333, 2.056};

edit::Json const& entryOf(Designer& designer, std::string const& name) {
    return *edit::findObject(designer.tree(), name);
}

TEST(EditorPieces, AreSelectedByADoubleClickAndChanged) {
    Designer designer;
    designer.editText(bells);
    std::string const before = designer.parts().document.text();
    designer.select(onStriker);
    EXPECT_EQ(designer.parts().selected(), std::vector<std::string>{"front bell"});
    EXPECT_EQ(designer.parts().selection.piece(), "") << "a click selects the whole";
    designer.frames(30);
    designer.doubleClick(designer.on(onStriker));
    EXPECT_EQ(designer.parts().selected(), std::vector<std::string>{"front bell"});
    ASSERT_EQ(designer.parts().selection.piece(), "striker");
    EXPECT_EQ(designer.parts().tab, Tab::properties);
    designer.frames(2);
    designer.look("edit-piece");
    EXPECT_FALSE(designer.shows("at x")) << "it lies where its part says";
    designer.seek("density");
    designer.drag(designer.item("density"), designer.item("density") + Point{40, 0});
    auto const& pieces = entryOf(designer, "front bell")["pieces"];
    ASSERT_TRUE(pieces.contains("striker"));
    EXPECT_GT(pieces["striker"]["density"].get<double>(), 7800);
    EXPECT_EQ(designer.parts().document.undoName(), "Change density of piece 'striker' of front bell");
    EXPECT_EQ(designer.parts().selection.piece(), "striker") << "it is still selected";
    designer.look("edit-piece-changed");
    designer.seek("reset density");
    designer.clickItem("reset density");
    EXPECT_FALSE(entryOf(designer, "front bell").contains("pieces"));
    designer.key(SDLK_ESCAPE);
    EXPECT_EQ(designer.parts().selection.piece(), "") << "first the piece is let go";
    EXPECT_EQ(designer.parts().selected().size(), 1U);
    designer.key(SDLK_ESCAPE);
    EXPECT_TRUE(designer.parts().selected().empty());
    designer.ctrl(SDLK_z);
    designer.ctrl(SDLK_z);
    EXPECT_EQ(designer.parts().document.text(), before);
}

TEST(EditorPieces, BelongToTheirOwnEntryWhateverItsName) {
    Designer designer;
    // The name of the left wheel of "a" begins with the name of the other cart.
    designer.editText(R"({"version": 2, "title": "Carts", "world": {"bounds": [-4, -0.5, 8, 4.5]},
        "objects": [{"name": "a", "part": "cart", "at": [-2, 1]},
                    {"name": "a left", "part": "cart", "at": [2, 1]}]})");
    for (auto const& [entry, x] : {std::pair("a", -2.0), std::pair("a left", 2.0)}) {
        Vec2 const onLeftWheel{x - 0.35, 0.8};
        designer.select(onLeftWheel);
        EXPECT_EQ(designer.parts().selected(), std::vector<std::string>{entry});
        designer.frames(30);
        designer.doubleClick(designer.on(onLeftWheel));
        EXPECT_EQ(designer.parts().selected(), std::vector<std::string>{entry});
        EXPECT_EQ(designer.parts().selection.piece(), "left wheel") << entry;
        designer.key(SDLK_ESCAPE);
        designer.key(SDLK_ESCAPE);
        designer.frames(30);
    }
    auto const within = objectsWithin(designer.parts(), {-3, 0}, {-1, 2});
    EXPECT_EQ(within, std::vector<std::string>{"a"}) << "all pieces of it are within";
}

TEST(EditorPieces, AreResetByDeleteAndNeverRemoved) {
    Designer designer;
    designer.editText(bells);
    std::string const before = designer.parts().document.text();
    designer.parts().selection.set({"front bell"});
    designer.parts().selection.choosePiece("striker");
    designer.parts().run([&](edit::Json const& level) {
        return edit::setField(*designer.parts().data, level, {"front bell"}, "density", "", 4000, "striker");
    });
    ASSERT_TRUE(entryOf(designer, "front bell").contains("pieces"));
    designer.key(SDLK_DELETE);
    EXPECT_EQ(designer.parts().document.text(), before);
    EXPECT_EQ(designer.parts().document.undoName(), "Reset piece 'striker' of front bell");
    EXPECT_EQ(designer.parts().selection.piece(), "striker");
    auto const toasts = designer.app().context().toasts.count();
    designer.key(SDLK_DELETE);
    EXPECT_EQ(designer.parts().document.text(), before);
    EXPECT_EQ(designer.app().context().toasts.count(), toasts + 1) << "a message says that a piece stays";
    designer.look("edit-piece-stays");
    designer.key(SDLK_ESCAPE);
    designer.key(SDLK_DELETE);
    EXPECT_EQ(edit::findObject(designer.tree(), "front bell"), nullptr) << "the whole";
}

TEST(EditorPieces, AreChosenInTheInspectorOfSeveralObjects) {
    Designer designer;
    designer.editText(bells);
    designer.parts().selection.set({"front bell", "back bell"});
    designer.key(SDLK_F4);
    designer.frames(2);
    designer.clickItem("piece");
    designer.frames(2);
    EXPECT_FALSE(designer.shows("piece = backboard")) << "the whole has its properties";
    designer.clickItem("piece = contact");
    designer.frames(2);
    ASSERT_EQ(designer.parts().selection.piece(), "contact");
    designer.seek("friction");
    designer.drag(designer.item("friction"), designer.item("friction") + Point{40, 0});
    for (char const* const name : {"front bell", "back bell"}) {
        EXPECT_GT(entryOf(designer, name)["pieces"]["contact"]["friction"].get<double>(), 0.5) << name;
    }
    designer.seek("reset piece");
    designer.look("edit-piece-several");
    designer.clickItem("reset piece");
    EXPECT_FALSE(entryOf(designer, "front bell").contains("pieces"));
    EXPECT_FALSE(entryOf(designer, "back bell").contains("pieces"));
    designer.parts().selection.set({"front bell", "floor"});
    designer.frames(2);
    EXPECT_FALSE(designer.shows("piece"));
}

TEST(EditorPieces, ProblemsLeadToThem) {
    Designer designer;
    designer.editText(bells);
    designer.parts().selection.set({"front bell"});
    designer.parts().selection.choosePiece("striker");
    designer.key(SDLK_F4);
    designer.frames(2);
    designer.seek("density");
    designer.drag(designer.item("density"), designer.item("density") + Point{40, 0});
    designer.parts().run(
        [&](edit::Json const& level) { return edit::setPart(level, {"front bell"}, "relay"); });
    designer.frames(40);
    designer.parts().selection.clear();
    designer.key(SDLK_F8);
    designer.frames(2);
    auto const& problems = designer.parts().problems.all();
    std::size_t index = 0;
    while (index < problems.size() && problems[index].piece != "striker") {
        ++index;
    }
    ASSERT_LT(index, problems.size());
    designer.clickItem("problem " + std::to_string(index));
    designer.frames(2);
    EXPECT_EQ(designer.parts().selected(), std::vector<std::string>{"front bell"});
    EXPECT_EQ(designer.parts().selection.piece(), "striker");
    EXPECT_EQ(designer.parts().tab, Tab::properties);
    designer.look("edit-piece-problem");
    designer.seek("reset piece");
    designer.clickItem("reset piece");
    EXPECT_FALSE(entryOf(designer, "front bell").contains("pieces"));
}

TEST(EditorPieces, CanBeWhatGoalsAreAbout) {
    Designer designer;
    designer.editText(bells);
    designer.key(SDLK_F5);
    designer.frames(2);
    designer.clickItem("goal ");
    designer.frames(2);
    designer.clickItem("goal/0");
    designer.frames(2);
    designer.clickItem("goal/0 = front bell coil");
    designer.frames(2);
    EXPECT_EQ(designer.tree()["goals"]["moved"]["object"], "front bell coil");
}

TEST(EditorPieces, AnObjectIsFlippedByACheckBox) {
    Designer designer;
    designer.editText(bells);
    designer.parts().selection.set({"back bell"});
    designer.key(SDLK_F4);
    designer.frames(2);
    designer.clickItem("object flipped");
    designer.frames(2);
    EXPECT_EQ(entryOf(designer, "back bell")["flipped"], true);
    designer.clickItem("object flipped");
    designer.frames(2);
    EXPECT_FALSE(entryOf(designer, "back bell").contains("flipped"));
}

} // namespace
} // namespace pieces_test
} // namespace trembler::ui::test
