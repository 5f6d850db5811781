// Ctrl+P finds parts and kinds of joints, and says if nothing is called so.
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace palette_entries_test {
namespace {

auto const level = levelsFolder() / "first/1-first-contact.json";

// It knew commands only, and an empty list said nothing.
TEST(PaletteEntries, ArePartsAndKindsOfJoints) {
    Designer designer;
    designer.editCopyOf(level);
    std::size_t const before = designer.count("objects");
    auto const find = [&](std::string const& name) {
        designer.ctrl(SDLK_p);
        designer.frames(2);
        designer.typeText(name);
        designer.frames(2);
        designer.look("edit-palette-" + name);
    };
    find("anvil");
    designer.key(SDLK_RETURN);
    EXPECT_EQ(designer.parts().partInHand, "anvil");
    designer.click(designer.on({0.5, 2}));
    ASSERT_EQ(designer.count("objects"), before + 1);
    EXPECT_EQ(designer.tree()["objects"].back()["part"], "anvil");
    find("spring");
    designer.clickItem("found joint spring");
    EXPECT_EQ(designer.parts().tool, Tool::joint);
    EXPECT_EQ(designer.parts().jointForm, "spring");
    EXPECT_EQ(designer.count("objects"), before + 1);
    find("qqq");
    auto const lines = DrawnWords().lines();
    EXPECT_EQ(std::count(lines.begin(), lines.end(), "Nothing is called that."), 1);
}

} // namespace
} // namespace palette_entries_test
} // namespace trembler::ui::test
