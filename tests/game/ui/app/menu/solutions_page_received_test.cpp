// A solution of another player is opened in the game: by a button, without a mouse, or dropped onto the
// window.
#include "game/ui/shared/texts.hpp"
#include "runtime/file/output_file.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/write/write_level.hpp"
#include "tests/game/ui/tidy.hpp"
#include "tests/game/ui/virtual_pad.hpp"

#include <cstdlib>

namespace trembler::ui::test {
namespace received_solutions_test {
namespace {

namespace fs = std::filesystem;
auto const contactLevel = levelsFolder() / "first/1-first-contact.json";
std::string const contactId = "first/1-first-contact.json";

/// The player's home, with a folder of downloads that contains a friend's solution.
class ReceivedSolution : public testing::Test {
protected:
    ReceivedSolution() : home_(testFolder() / "home") {
        fs::remove_all(player.films());
        fs::remove_all(home_);
        fs::create_directories(home_ / "Downloads");
        if (char const* const before = std::getenv("HOME")) {
            homeBefore_ = before;
        }
        setenv("HOME", home_.c_str(), 1);
        setenv("XDG_CONFIG_HOME", (home_ / ".config").c_str(), 1);
        player.open(contactLevel);
        Solution solution = player.session().level().solutions.front();
        solution.name = "of a friend";
        writeFile(friends(), escapedJson(writeSolution(solution).dump(2)) + "\n");
    }
    ~ReceivedSolution() override { setenv("HOME", homeBefore_.c_str(), 1); }

    [[nodiscard]] fs::path friends() const { return home_ / "Downloads/from-a-friend.json"; }
    fs::path written(std::string const& name, std::string const& text) {
        fs::path const file = home_ / "Downloads" / name;
        writeFile(file, text);
        return file;
    }
    void drop(fs::path const& file) {
        render::pushDrop(window(), file);
        player.frames(2);
    }
    std::vector<SavedSolution> kept() { return player.app().context().solutions.of(contactId); }
    /// Whether the friend's solution is placed and kept, and solves the level.
    void expectReceived() {
        ASSERT_FALSE(player.app().menu().isOpen());
        ASSERT_FALSE(player.session().placed().empty());
        ASSERT_EQ(kept().size(), 1U);
        EXPECT_EQ(kept()[0].name, "of a friend");
        player.key(SDLK_SPACE);
        player.simulate(600);
        EXPECT_TRUE(player.session().solved());
    }
    void openPage() {
        player.key(SDLK_ESCAPE);
        player.frames(3);
        player.clickItem("menu.solutions");
        player.frames(3);
    }
    Player player;

private:
    fs::path home_;
    std::string homeBefore_;
};

TEST_F(ReceivedSolution, IsOpenedByTheButton) {
    openPage();
    expectTidy(player, "the page of solutions, with none yet");
    player.clickItem("open solution");
    player.frames(3);
    expectTidy(player, "the files that arrived");
    player.look("solutions-browser-720");
    EXPECT_TRUE(player.showsCard("file browser"));
    player.clickItem("file from-a-friend.json");
    player.frames(3);
    expectReceived();
}

TEST_F(ReceivedSolution, IsOpenedByKeysAlone) {
    player.key(SDLK_ESCAPE);
    player.frames(3);
    for (int i = 0; i < 3; ++i) { // resume, start again, solutions
        player.key(SDLK_DOWN);
    }
    player.key(SDLK_RETURN);
    player.frames(3);
    player.key(SDLK_RETURN); // the ring is at the first button, "Open a file"
    player.frames(3);
    ASSERT_TRUE(player.showsCard("file browser"));
    player.key(SDLK_ESCAPE);
    player.frames(3);
    EXPECT_EQ(player.app().menu().page(), MenuPage::solutions) << "Esc leads back to the page";
    player.key(SDLK_RETURN);
    player.frames(3);
    player.key(SDLK_DOWN); // from the folder above to the first file
    player.key(SDLK_RETURN);
    player.frames(3);
    expectReceived();
}

TEST_F(ReceivedSolution, IsOpenedByAGamepadAlone) {
    VirtualPad const pad;
    ASSERT_TRUE(pad.works());
    player.frames(2);
    pad.press(player, SDL_CONTROLLER_BUTTON_START);
    player.frames(3);
    for (int i = 0; i < 3; ++i) {
        pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    }
    pad.press(player, SDL_CONTROLLER_BUTTON_A);
    player.frames(3);
    pad.press(player, SDL_CONTROLLER_BUTTON_A);
    player.frames(3);
    ASSERT_TRUE(player.showsCard("file browser"));
    pad.press(player, SDL_CONTROLLER_BUTTON_B);
    player.frames(3);
    EXPECT_EQ(player.app().menu().page(), MenuPage::solutions) << "B leads back to the page";
    pad.press(player, SDL_CONTROLLER_BUTTON_A);
    player.frames(3);
    pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    pad.press(player, SDL_CONTROLLER_BUTTON_A);
    player.frames(3);
    expectReceived();
}

TEST_F(ReceivedSolution, IsKeptOnceHoweverOftenItIsDropped) {
    openPage();
    drop(friends()); // with the menu open, too
    drop(friends());
    expectReceived();
}

TEST_F(ReceivedSolution, MayHaveANameInAnyLetters) {
    fs::path const file = friends().parent_path() / fs::path(u8"Lösung für Ada.json");
    fs::rename(friends(), file);
    drop(file);
    expectReceived();
}

TEST_F(ReceivedSolution, IsRefusedInWordsIfItIsWrong) {
    struct Case {
        char const* file;
        char const* text;
        char const* said;
    };
    for (Case const& tried :
         {Case{"broken.json", "{", "broken.json cannot be opened:"},
          Case{"photo.json", "[1, 2]", "photo.json is neither a level nor a solution."},
          Case{"other.json", R"({"name": "x", "placements": [{"part": "crate", "at": [0, 9]}]})",
               "other.json is no solution of this level: "},
          Case{"wrong.json", R"({"name": "x", "placements": [{"part": 3}]})",
               "wrong.json is no solution of this level: "}}) {
        drop(written(tried.file, tried.text));
        auto const& toasts = player.app().context().toasts;
        EXPECT_NE(toasts.newest().find(tried.said), std::string::npos) << toasts.newest();
        EXPECT_TRUE(player.session().placed().empty());
        EXPECT_TRUE(kept().empty());
    }
    drop(friends().parent_path() / "no-such-file.json");
    EXPECT_TRUE(kept().empty());
    drop(friends());
    expectReceived();
}

TEST_F(ReceivedSolution, NeedsALevelButALevelOpensItself) {
    player.app().showTitle();
    player.frames(3);
    drop(friends());
    EXPECT_EQ(player.findPlay(), nullptr);
    EXPECT_EQ(player.app().context().toasts.newest(), text("solutions.no_level"));
    drop(contactLevel);
    ASSERT_NE(player.findPlay(), nullptr);
    drop(friends());
    expectReceived();
}

} // namespace
} // namespace received_solutions_test
} // namespace trembler::ui::test
