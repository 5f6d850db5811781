// A list of parts shows them as the catalogue does.
#include "game/ui/app/menu/settings_page.hpp"
#include "game/ui/shared/texts.hpp"
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace part_choice_test {
namespace {

auto const level = levelsFolder() / "first/1-first-contact.json";

// The list had the names of the files of parts, in English in German, too, and no pictures.
TEST(PartChoice, TheToolboxIsFilledByTitles) {
    Designer designer;
    changeSettings(designer.app().context(), {.language = "de"});
    designer.editCopyOf(level);
    designer.parts().tab = Tab::level;
    designer.frames(2);
    designer.seek("add tool");
    designer.clickItem("add tool");
    designer.frames(3);
    designer.look("edit-add-tool-list");
    designer.typeText("stahlkugel");
    designer.frames(2);
    designer.look("edit-add-tool-found");
    std::string const title = designer.parts().catalog().titleOf("steel ball");
    EXPECT_EQ(title, "Stahlkugel");
    auto const lines = DrawnWords().lines();
    EXPECT_GE(std::count(lines.begin(), lines.end(), title), 1);
    EXPECT_EQ(std::count(lines.begin(), lines.end(), "steel ball"), 0);
    designer.key(SDLK_RETURN);
    designer.frames(2);
    EXPECT_EQ(designer.tree()["toolbox"].back()["part"], "steel ball");
    designer.seek("add tool");
    designer.look("edit-add-tool-rows");
    useLanguage("en");
}

} // namespace
} // namespace part_choice_test
} // namespace trembler::ui::test
