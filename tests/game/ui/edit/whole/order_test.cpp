// The order of toolbox and solutions is changed in the editor, by mouse and by keyboard.
#include "runtime/level/json/limits.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <imgui_internal.h>

namespace trembler::ui::test {
namespace order_test {
namespace {

char const* const orderedLevel = R"({"version": 2, "title": "Order",
    "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4.5]},
    "objects": [
        {"name": "floor", "at": [0, -0.15], "properties": {"material": "stone", "fixed": true,
         "shape": [{"form": "box", "width": 7.6, "height": 0.3}]}},
        {"name": "ball", "part": "rubber ball", "at": [0, 1]}],
    "toolbox": [{"part": "plank", "count": 2}, {"wire": 3}, {"part": "steel ball", "count": 1}],
    "goals": {"moved": {"object": "ball", "by": 1}},
    "solutions": [
        {"name": "one", "expect": "unsolved", "frames": 10},
        {"name": "two", "expect": "unsolved", "frames": 20},
        {"name": "three", "expect": "unsolved", "frames": 30}]})";

std::string toolsOf(Designer& designer) {
    std::string all;
    for (auto const& tool : designer.tree()["toolbox"]) {
        all += (tool.contains("wire") ? "wire" : tool["part"].get<std::string>()) + ", ";
    }
    return all;
}

std::string solutionsOf(Designer& designer) {
    std::string all;
    for (auto const& solution : designer.tree()["solutions"]) {
        all += solution["name"].get<std::string>() + ", ";
    }
    return all;
}

/// Whether the keyboard's ring is on an item of the panel.
bool ringIsOn(Designer& designer, std::string const& item) {
    ImGuiContext const& context = *ImGui::GetCurrentContext();
    auto const rect = designer.layout().item(item);
    if (context.NavWindow == nullptr || !rect) {
        return false;
    }
    ImRect const ring =
        ImGui::WindowRectRelToAbs(context.NavWindow, context.NavWindow->NavRectRel[ImGuiNavLayer_Main]);
    return rect->contains({ring.GetCenter().x, ring.GetCenter().y});
}

/// Moves the ring down to the row of an item, then right to it.
void ringTo(Designer& designer, std::string const& item) {
    auto const inRow = [&] {
        ImGuiContext const& context = *ImGui::GetCurrentContext();
        auto const rect = designer.layout().item(item);
        if (context.NavWindow == nullptr || !rect) {
            return false;
        }
        ImRect const ring =
            ImGui::WindowRectRelToAbs(context.NavWindow, context.NavWindow->NavRectRel[ImGuiNavLayer_Main]);
        return ring.GetCenter().y > rect->low.y && ring.GetCenter().y < rect->high.y;
    };
    for (int i = 0; i < 80 && !inRow(); ++i) {
        designer.key(SDLK_DOWN);
        designer.frames(2);
    }
    for (int i = 0; i < 8 && !ringIsOn(designer, item); ++i) {
        designer.key(SDLK_RIGHT);
        designer.frames(2);
    }
    ASSERT_TRUE(ringIsOn(designer, item)) << item;
}

TEST(EditorOrder, OfTheToolboxByMouse) {
    Designer designer;
    designer.editText(orderedLevel);
    std::string const before = designer.parts().document.text();
    designer.key(SDLK_F6);
    designer.frames(3);
    designer.seek("tool 2 up");
    designer.look("edit-order-tools");
    designer.clickItem("tool 0 down");
    EXPECT_EQ(toolsOf(designer), "wire, plank, steel ball, ");
    EXPECT_EQ(designer.parts().document.undoName(), "Move part in the toolbox");
    designer.frames(2);
    designer.clickItem("tool 2 up");
    EXPECT_EQ(toolsOf(designer), "wire, steel ball, plank, ");
    designer.frames(2);
    designer.clickItem("tool 2 down");
    EXPECT_EQ(toolsOf(designer), "wire, steel ball, plank, ") << "it is the last one";
    designer.clickItem("tool 0 remove");
    EXPECT_EQ(toolsOf(designer), "steel ball, plank, ") << "wires can be taken out as well";
    designer.ctrl(SDLK_z);
    designer.ctrl(SDLK_z);
    designer.ctrl(SDLK_z);
    EXPECT_EQ(designer.parts().document.text(), before);
}

TEST(EditorOrder, TheNumberOfWiresIsDraggedFromNone) {
    Designer designer;
    std::string level = orderedLevel;
    level.erase(level.find("{\"wire\": 3}, "), std::string("{\"wire\": 3}, ").size());
    designer.editText(level);
    std::string const before = designer.parts().document.text();
    designer.key(SDLK_F6);
    designer.frames(3);
    designer.seek("wires");
    designer.drag(designer.item("wires"), designer.item("wires") + Point{160, 0});
    EXPECT_EQ(toolsOf(designer), "plank, steel ball, wire, ");
    EXPECT_GT(designer.tree()["toolbox"].back()["wire"].get<int>(), 3) << "the drag goes on";
    designer.ctrl(SDLK_z);
    EXPECT_EQ(designer.parts().document.text(), before) << "one change";
}

TEST(EditorOrder, ANumberWithoutEndIsTheNumberBeforeAgain) {
    Designer designer;
    designer.editText(orderedLevel);
    std::string const before = designer.parts().document.text();
    designer.key(SDLK_F6);
    designer.frames(3);
    auto const press = [&](char const* item) {
        designer.seek(item);
        designer.clickItem(item);
        designer.frames(2);
    };
    auto const countsOf = [&] {
        return designer.tree()["toolbox"][0]["count"].dump() + " " +
               designer.tree()["toolbox"][1]["wire"].dump();
    };
    press("tool 0 unlimited");
    press("wires unlimited");
    EXPECT_EQ(countsOf(), R"("unlimited" "unlimited")");
    press("wires unlimited");
    press("tool 0 unlimited");
    EXPECT_EQ(countsOf(), "2 3");
    EXPECT_EQ(designer.parts().document.text(), before);
    // Also where the entry has moved meanwhile.
    press("tool 0 unlimited");
    press("tool 0 down");
    press("tool 1 unlimited");
    EXPECT_EQ(designer.tree()["toolbox"][1]["count"].dump(), "2");
}

// It has no number before.
TEST(EditorOrder, ANumberThatIsWithoutEndInTheFileBecomesOne) {
    std::string level = orderedLevel;
    level.replace(level.find("\"count\": 2"), 10, "\"count\": \"unlimited\"");
    Designer designer;
    designer.editText(level);
    designer.key(SDLK_F6);
    designer.frames(3);
    designer.seek("tool 0 unlimited");
    designer.clickItem("tool 0 unlimited");
    designer.frames(2);
    EXPECT_EQ(designer.tree()["toolbox"][0]["count"].dump(), "1");
}

TEST(EditorOrder, OfSolutionsBesideUnreadableOnes) {
    Designer designer;
    std::string level = orderedLevel;
    level.insert(level.find("{\"name\": \"one\""), "3, ");
    level.insert(level.find("{\"name\": \"three\""), "4, ");
    designer.editText(level);
    if (designer.parts().document.readOnly()) {
        designer.clickItem("edit nevertheless");
        designer.frames(2);
    }
    auto const ordered = [&] {
        std::string all;
        for (auto const& solution : designer.tree()["solutions"]) {
            all += (solution.is_object() ? solution["name"].get<std::string>() : solution.dump()) + ", ";
        }
        return all;
    };
    ASSERT_EQ(ordered(), "3, one, two, 4, three, ");
    ASSERT_EQ(designer.parts().level.solutions.size(), 3U);
    designer.key(SDLK_F7);
    designer.frames(3);
    designer.clickItem("solution 0 down");
    EXPECT_EQ(ordered(), "3, two, one, 4, three, ");
    designer.frames(2);
    designer.clickItem("solution 2 up");
    EXPECT_EQ(ordered(), "3, two, three, one, 4, ");
}

TEST(EditorOrder, OfSolutionsByMouse) {
    Designer designer;
    designer.editText(orderedLevel);
    std::string const before = designer.parts().document.text();
    designer.key(SDLK_F7);
    designer.frames(3);
    designer.look("edit-order-solutions");
    designer.clickItem("solution 0 down");
    EXPECT_EQ(solutionsOf(designer), "two, one, three, ");
    EXPECT_EQ(designer.parts().document.undoName(), "Move solution");
    designer.frames(2);
    designer.clickItem("solution 1 down");
    EXPECT_EQ(solutionsOf(designer), "two, three, one, ");
    designer.frames(2);
    designer.clickItem("solution 0 up");
    EXPECT_EQ(solutionsOf(designer), "two, three, one, ") << "it is the first one";
    designer.drag(designer.item("solution 0 frames"), designer.item("solution 0 frames") + Point{60, 0});
    EXPECT_GT(designer.tree()["solutions"][0]["frames"].get<int>(), 20);
    designer.parts().document.goTo(0);
    EXPECT_EQ(designer.parts().document.text(), before);
}

/// Shows a page of the panel, with the ring of the keyboard in it.
void pageByKeys(Designer& designer, SDL_Keycode page) {
    designer.key(page);
    designer.frames(2);
    designer.key(SDLK_F9);
    designer.frames(3);
}

/// With either key that presses a button: the tip of the panel's command names Enter.
class EditorOrderByKey : public testing::TestWithParam<SDL_Keycode> {};

INSTANTIATE_TEST_SUITE_P(Keys, EditorOrderByKey, testing::Values(SDLK_SPACE, SDLK_RETURN),
                         [](auto const& key) { return key.param == SDLK_SPACE ? "Space" : "Enter"; });

TEST_P(EditorOrderByKey, TheRingStaysWithWhatIsMoved) {
    Designer designer;
    designer.editText(orderedLevel);
    pageByKeys(designer, SDLK_F7);
    ringTo(designer, "solution 0 down");
    designer.key(GetParam());
    designer.frames(3);
    EXPECT_EQ(solutionsOf(designer), "two, one, three, ");
    EXPECT_TRUE(ringIsOn(designer, "solution 1 down"));
    designer.key(GetParam());
    designer.frames(3);
    EXPECT_EQ(solutionsOf(designer), "two, three, one, ");
    designer.key(SDLK_ESCAPE);
    pageByKeys(designer, SDLK_F6);
    ringTo(designer, "tool 0 down");
    designer.key(GetParam());
    designer.frames(3);
    EXPECT_EQ(toolsOf(designer), "wire, plank, steel ball, ");
}

TEST(EditorOrder, EnterTypesIntoANumberAndPressesWhatIsNone) {
    Designer designer;
    designer.editText(orderedLevel);
    pageByKeys(designer, SDLK_F7);
    designer.key(SDLK_DOWN);
    designer.frames(2);
    designer.key(SDLK_DOWN); // below the name
    designer.frames(2);
    EXPECT_TRUE(designer.tree()["solutions"][0].contains("expect"));
    designer.key(SDLK_RETURN);
    designer.frames(3);
    EXPECT_FALSE(designer.tree()["solutions"][0].contains("expect")) << "a box to tick";
    ringTo(designer, "solution 0 frames");
    auto const typeFrames = [&](std::string const& number) {
        designer.key(SDLK_RETURN);
        designer.frames(3);
        EXPECT_TRUE(designer.app().context().gui.wantsKeyboard()) << "it types";
        designer.key(SDLK_a, KMOD_LCTRL);
        designer.typeText(number);
        designer.key(SDLK_RETURN);
        designer.frames(4);
        EXPECT_FALSE(designer.app().context().gui.wantsKeyboard()) << "the Enter that ends it opens nothing";
        EXPECT_TRUE(designer.parts().panelKeys);
    };
    typeFrames("75");
    EXPECT_EQ(designer.tree()["solutions"][0]["frames"], 75);
    typeFrames("0"); // as the tip says: no limit
    EXPECT_FALSE(designer.tree()["solutions"][0].contains("frames"));
    typeFrames("99999999");
    EXPECT_EQ(designer.tree()["solutions"][0]["frames"], limits::frames) << "the most that there may be";
    EXPECT_EQ(designer.screen().test(), nullptr) << "the level is not played";
    for (SDL_Keycode const key : {SDLK_DOWN, SDLK_LEFT, SDLK_LEFT}) {
        designer.key(key);
        designer.frames(2);
    }
    ASSERT_TRUE(ringIsOn(designer, "solution 0 watch"));
    designer.key(SDLK_RETURN);
    designer.frames(3);
    EXPECT_NE(designer.screen().test(), nullptr) << "a button with words";
}

} // namespace
} // namespace order_test
} // namespace trembler::ui::test
