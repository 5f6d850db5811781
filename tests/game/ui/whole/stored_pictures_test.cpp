// Every screen at 1280x720 in English looks as it is stored in tests/game/ui/stored.
//
// With TREMBLER_STORE_PICTURES in the environment the pictures are written there again instead:
// docs/contributors.md.
#include "game/ui/app/menu/settings_page.hpp"
#include "tests/game/ui/screen_walk.hpp"
#include "tests/game/ui/stored_picture.hpp"
#include "tests/support/read_png.hpp"

#include <SDL_clipboard.h>

#include <cstdlib>
#include <set>

namespace trembler::ui::test {
namespace {

namespace fs = std::filesystem;

fs::path storedFolder() {
    return fs::path(TREMBLER_SOURCE_DIR) / "tests/game/ui/stored";
}

/// Cards with measured times, which differ from run to run.
std::vector<Ignored> timesOn(Layout const& layout) {
    std::vector<Ignored> ignored;
    if (auto const card = layout.card("components")) {
        ignored.push_back({card->low, card->high});
    }
    return ignored;
}

void compareWithStored(Player& player, std::string const& screen) {
    render::Image const picture = player.look("screen-" + screen);
    render::Image const got = inBlocks(picture, timesOn(player.layout()));
    fs::path const file = storedFolder() / (screen + ".png");
    if (std::getenv("TREMBLER_STORE_PICTURES") != nullptr) {
        // Pictures that differ by less than the tolerance stay as they are.
        if (!fs::exists(file) || !compare(render::readPng(file), got).same()) {
            writePng(got, file);
        }
        return;
    }
    ASSERT_TRUE(fs::exists(file)) << "no picture of the screen \"" << screen << "\" is stored";
    render::Image const expected = render::readPng(file);
    Comparison const comparison = compare(expected, got);
    if (!comparison.same()) {
        fs::path const shown = testFolder() / (screen + ".png");
        writePng(beside({expected, got, comparison.difference}), shown);
        ADD_FAILURE() << "The screen \"" << screen << "\" differs from its stored picture in "
                      << 100 * comparison.share << " % of the blocks. Expected, got and difference are in "
                      << shown;
    }
}

/// The screens of one part of the walk.
void expectAsStored(void (*walk)(Player&, Look const&)) {
    Player player;
    ASSERT_EQ(SDL_SetClipboardText(""), 0) << "or what another test has copied could be pasted";
    changeSettings(player.app().context(), {.reducedMotion = true, .language = "en"});
    walk(player, [&](std::string const& screen) {
        player.frames(45); // one picture of a level is drawn in each, and letters know their size
        compareWithStored(player, screen);
    });
}

TEST(StoredPictures, TitleAndMenus) {
    expectAsStored(walkMenus);
}

TEST(StoredPictures, ALevel) {
    expectAsStored(walkLevel);
}

TEST(StoredPictures, DemonstrationsPanelsAndFreePlay) {
    expectAsStored(walkOthers);
}

TEST(StoredPictures, TheEditor) {
    expectAsStored(walkEditor);
}

TEST(StoredPictures, AreThoseOfTheWalk) {
    std::set<std::string> walked;
    Player player;
    walkScreens(player, [&](std::string const& screen) {
        EXPECT_TRUE(walked.insert(screen + ".png").second) << screen << " is the name of two screens";
    });
    for (auto const& entry : fs::directory_iterator(storedFolder())) {
        EXPECT_TRUE(walked.contains(entry.path().filename())) << entry.path() << " is of no screen";
    }
}

} // namespace
} // namespace trembler::ui::test
