// Keys in the profile file: saved, read, and damaged.
#include "game/ui/shared/kept/profile.hpp"
#include "tests/game/ui/player.hpp"

#include <fstream>

namespace trembler::ui::test {
namespace {

class ProfileFile : public testing::Test {
protected:
    ProfileFile() { std::filesystem::remove_all(folder); }

    [[nodiscard]] std::filesystem::path written(std::string const& text) const {
        std::filesystem::create_directories(folder);
        auto const file = folder / "profile.json";
        std::ofstream(file) << text;
        return file;
    }

    std::filesystem::path const folder = testFolder() / "profile";
};

TEST_F(ProfileFile, KeysAreKeptBesideTheRest) {
    auto const file = folder / "deep" / "profile.json";
    {
        Profile profile(file);
        profile.setKeys({{"run", {"Ctrl+R", "F5"}}, {"hint", {}}});
        profile.markSolved("a level");
        Settings settings = profile.settings();
        settings.volume = 30;
        settings.touches = 20;
        settings.clearColours = true;
        profile.setSettings(settings);
    }
    Profile const kept(file);
    EXPECT_EQ(kept.keys(), (StatedKeys{{"run", {"Ctrl+R", "F5"}}, {"hint", {}}}));
    EXPECT_TRUE(kept.troubles().empty());
    EXPECT_TRUE(kept.solved("a level"));
    EXPECT_EQ(kept.settings().volume, 30);
    EXPECT_EQ(kept.settings().touches, 20);
    EXPECT_TRUE(kept.settings().clearColours);
}

TEST_F(ProfileFile, ADamagedEntryIsReportedAndTheOthersAreKept) {
    Profile const profile(written(
        R"({"volume": 20, "keys": {"run": "Space", "hint": ["F2"], "cut": [1], "names": null}, "solved": ["x"]})"));
    EXPECT_EQ(profile.keys(), (StatedKeys{{"hint", {"F2"}}}));
    EXPECT_EQ(profile.troubles().size(), 3U);
    EXPECT_EQ(profile.settings().volume, 20);
    EXPECT_TRUE(profile.solved("x"));
    for (char const* keys : {"[]", "7", "\"Space\"", "null"}) {
        Profile const none(written(std::string(R"({"volume": 20, "keys": )") + keys + "}"));
        EXPECT_TRUE(none.keys().empty()) << keys;
        EXPECT_EQ(none.troubles().size(), 1U) << keys;
        EXPECT_EQ(none.settings().volume, 20) << keys;
    }
}

TEST_F(ProfileFile, TheGameReportsTheErrorAndContinues) {
    auto const file = written(R"({"keys": {"hint": ["P"], "run": ["F5"], "save": 3}})");
    Player player({1280, 720}, file);
    EXPECT_EQ(player.app().context().toasts.count(), 2U);
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.key(SDLK_h);
    EXPECT_EQ(player.play().hintsShown(), 1U) << "P belongs to another command, so H still is the key";
    player.key(SDLK_SPACE);
    EXPECT_EQ(player.session().mode(), SessionMode::building);
    player.key(SDLK_F5);
    EXPECT_EQ(player.session().mode(), SessionMode::running);
}

} // namespace
} // namespace trembler::ui::test
