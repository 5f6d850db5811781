// The mods' panel, and scripts that are saved while the game shows their level.
#include "game/ui/panels/mods_panel.hpp"
#include "game/ui/shared/words.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/tidy.hpp"

#include <chrono>
#include <fstream>

namespace trembler::ui::test {
namespace {

namespace fs = std::filesystem;

auto const breezeLevel = dataFolder() / "breeze.json";

lua::Value speedOf(Player& player) {
    return player.play().liveMods()->users(0).front().values.at("speed");
}

class ModsPanelSizes : public testing::TestWithParam<render::Size> {};

TEST_P(ModsPanelSizes, ShowsEachScriptWithItsBoxAndItsParameters) {
    Player player(GetParam());
    player.open(breezeLevel);
    EXPECT_TRUE(player.shows("mods")) << "a button";
    player.key(SDLK_m);
    player.frames(4);
    ASSERT_TRUE(player.showsCard("mods"));
    EXPECT_TRUE(player.shows("script Dynamics <- Calm"));
    EXPECT_FALSE(player.shows("speed of Dynamics <- Breeze")) << "folded";
    expectTidy(player, "folded");
    player.clickItem("script Dynamics <- Breeze");
    player.frames(3);
    for (char const* const item :
         {"switch of Dynamics <- Breeze", "script Dynamics <- Breeze", "object of Dynamics <- Breeze"}) {
        EXPECT_TRUE(player.shows(item)) << item;
    }
    expectTidy(player, "building");
    player.scrollTo("mods", "speed of Dynamics <- Breeze");
    EXPECT_TRUE(player.shows("speed of Dynamics <- Breeze"));
    expectTidy(player, "scrolled");
    player.look("mods-building-" + std::to_string(GetParam().height));
    player.key(SDLK_SPACE);
    player.simulate(64);
    expectTidy(player, "running");
    player.look("mods-running-" + std::to_string(GetParam().height));
    player.key(SDLK_c);
    player.frames(3);
    EXPECT_FALSE(player.play().mods().open()) << "the two panels lie in one place";
    player.key(SDLK_m);
    player.frames(3);
    EXPECT_FALSE(player.play().components().open());
    player.key(SDLK_m);
    player.frames(3);
    EXPECT_FALSE(player.showsCard("mods"));
}

INSTANTIATE_TEST_SUITE_P(Sizes, ModsPanelSizes,
                         testing::Values(render::Size{1280, 720}, render::Size{3840, 2160}),
                         [](auto const& info) { return "lines" + std::to_string(info.param.height); });

/// Opens the level, the panel, and the script on it.
void openBreeze(Player& player) {
    player.open(breezeLevel);
    player.key(SDLK_m);
    player.frames(4);
    player.clickItem("script Dynamics <- Breeze");
    player.frames(3);
}

TEST(ModsPanel, ASliderChangesTheScriptWhileTheWorldRunsAndTheRunCountsNoMore) {
    Player player;
    openBreeze(player);
    player.key(SDLK_SPACE);
    player.simulate(16);
    lua::Value const before = speedOf(player);
    EXPECT_FALSE(player.session().altered());
    player.scrollTo("mods", "speed of Dynamics <- Breeze");
    auto const slider = player.layout().item("speed of Dynamics <- Breeze");
    ASSERT_TRUE(slider);
    player.click({slider->high.x - 0.1 * (slider->high.x - slider->low.x), slider->middle().y});
    EXPECT_NE(speedOf(player), before);
    EXPECT_GT(std::get<double>(speedOf(player)), std::get<double>(before));
    EXPECT_TRUE(player.session().altered());
    player.frames(2);
    player.simulate(320);
    EXPECT_TRUE(player.session().solved());
    EXPECT_FALSE(player.showsCard("success")) << "that run does not count";
    player.scrollTo("mods", "as stated, Dynamics <- Breeze");
    EXPECT_TRUE(player.shows("as stated, Dynamics <- Breeze"));
    player.look("mods-tuned");
    player.clickItem("as stated, Dynamics <- Breeze");
    EXPECT_EQ(speedOf(player), before);
    player.key(SDLK_SPACE); // stops
    EXPECT_FALSE(player.session().altered());
}

TEST(ModsPanel, ASwitchRestsTheScriptAndNothingIsCelebrated) {
    Player player;
    openBreeze(player);
    player.clickItem("switch of Dynamics <- Breeze");
    EXPECT_FALSE(player.play().liveMods()->scripts().front().live->on());
    player.key(SDLK_SPACE);
    player.simulate(64);
    EXPECT_TRUE(player.session().altered());
    EXPECT_FALSE(player.showsCard("success"));
    player.clickItem("switch of Dynamics <- Breeze");
    EXPECT_TRUE(player.play().liveMods()->scripts().front().live->on());
}

TEST(ModsPanel, ALevelWithoutModsHasNoButtonAndTheKeySaysSo) {
    Player player;
    player.open(levelsFolder() / "first/1-first-contact.json");
    EXPECT_FALSE(player.shows("mods"));
    auto const toasts = player.app().context().toasts.count();
    player.key(SDLK_m);
    EXPECT_EQ(player.app().context().toasts.count(), toasts + 1);
    EXPECT_FALSE(player.showsCard("mods"));
    EXPECT_EQ(player.play().liveMods(), nullptr);
}

/// A mod and a level of the test's own, in its folder.
class SavedScripts : public testing::Test {
protected:
    void SetUp() override {
        folder = testFolder();
        fs::remove_all(folder / "mods");
        fs::create_directories(folder / "mods/pushing/interactions");
        std::ofstream(folder / "mods/pushing/mod.json")
            << R"({"name": "pushing", "version": "1", "author": "me", "licence": "CC0-1.0"})";
        std::ofstream(folder / "level.json") << R"({"version": 2, "title": "Pushed", "mods": ["pushing"],
            "world": {"gravity": [0, 0]}, "objects": [{"name": "box", "at": [0, 0], "properties": {"mass": 10,
            "shape": [{"form": "box", "width": 1, "height": 1}], "scripts": [{"script": "Dynamics <- Push"}]}}]})";
        save("out.addForce(object, vec2(10, 0))");
    }
    void save(std::string const& body) {
        fs::path const file = folder / "mods/pushing/interactions/push.lua";
        std::ofstream(file)
            << "return interaction {\n  name = \"Dynamics <- Push\", calls = \"Dynamics\",\n"
               "  text = \"Pushes.\", reads = { \"Mass\" }, attached = true, each = { \"Mass\" },\n"
               "  restless = true,\n  apply = function(object, params, out)\n    "
            << body << "\n  end,\n}\n";
        fs::last_write_time(file, fs::file_time_type(std::chrono::seconds(++saves)));
    }
    static double speedOfBox(Player& player) {
        World const& world = player.session().world();
        return world.find<Velocity>(world.store().find("box"))->value.x;
    }
    fs::path folder;
    int saves = 0;
};

TEST_F(SavedScripts, AreUsedByTheRunningWorldWithinASecond) {
    Player player;
    player.open(folder / "level.json");
    player.key(SDLK_SPACE);
    player.simulate(64);
    double const before = speedOfBox(player);
    EXPECT_GT(before, 0.5);
    save("out.addForce(object, vec2(-10, 0))");
    auto const toasts = player.app().context().toasts.count();
    player.frames(40); // of a sixtieth of a second each, without waiting for a clock
    EXPECT_EQ(player.app().context().toasts.count(), toasts + 1);
    EXPECT_EQ(player.play().liveMods()->scripts().front().saved, 1);
    double const then = speedOfBox(player);
    player.simulate(32);
    EXPECT_LT(speedOfBox(player), then);
    EXPECT_TRUE(player.session().altered());
}

TEST_F(SavedScripts, WithAMistakeLeaveTheOldOneAndTheMessageIsOnThePanel) {
    Player player;
    player.open(folder / "level.json");
    player.key(SDLK_m);
    player.key(SDLK_SPACE);
    player.simulate(16);
    save("out.addForce(object vec2(-10, 0))");
    player.frames(40);
    ModScript const& script = player.play().liveMods()->scripts().front();
    ASSERT_EQ(script.refused.size(), 1U);
    EXPECT_NE(script.refused.front().find("push.lua:6:"), std::string::npos) << script.refused.front();
    expectTidy(player, "a file that is not used");
    player.look("mods-refused");
    double const then = speedOfBox(player);
    player.simulate(16);
    EXPECT_GT(speedOfBox(player), then) << "the old version goes on";
    save("error(\"no such thing\")");
    player.frames(40);
    ASSERT_TRUE(script.failure);
    expectTidy(player, "a script that fails");
    player.look("mods-failed");
}

TEST_F(SavedScripts, ReplaceTheWorldThatIsBeingBuilt) {
    Player player;
    player.open(folder / "level.json");
    save("out.addForce(object, vec2(-10, 0))");
    player.frames(40);
    EXPECT_FALSE(player.session().altered()) << "this run has only seen the new version";
    player.key(SDLK_SPACE);
    player.simulate(16);
    EXPECT_LT(speedOfBox(player), 0);
    EXPECT_FALSE(player.session().altered());
}

TEST_F(SavedScripts, WakeAWindowAtRest) {
    Player player;
    player.open(folder / "level.json");
    player.frames(240);
    ASSERT_TRUE(player.app().resting());
    save("out.addForce(object, vec2(-10, 0))");
    int frames = 0;
    while (player.app().resting() && frames < 60) { // undrawn, as in the main loop
        player.app().frame(1.0 / 60, false);
        ++frames;
    }
    EXPECT_LT(frames, 60) << "a second";
    EXPECT_EQ(player.play().liveMods()->scripts().front().saved, 1);
    EXPECT_EQ(player.app().context().toasts.count(), 1U);
}

TEST_F(SavedScripts, OfAMissingModAreReportedBeforeTheLevelStarts) {
    fs::remove_all(folder / "mods");
    Player player({1280, 720}, {}, folder);
    LevelCatalog const& levels = player.app().context().levels;
    CatalogEntry const* const entry = levels.find(folder / "level.json");
    ASSERT_NE(entry, nullptr);
    EXPECT_NE(entry->trouble.find("needs the mod 'pushing', which is not in "), std::string::npos)
        << entry->trouble;
    EXPECT_THROW(player.app().open(folder / "level.json"), InputError);
    EXPECT_EQ(player.findPlay(), nullptr);
}

} // namespace
} // namespace trembler::ui::test
