// Free play with the parts of installed mods: they can be placed, they work, and they are there again.
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/tidy.hpp"

#include <algorithm>
#include <fstream>

namespace trembler::ui::test {
namespace free_play_mods_test {
namespace {

namespace fs = std::filesystem;

class FreePlayMods : public testing::Test {
protected:
    FreePlayMods() {
        fs::remove_all(folder);
        fs::create_directories(folder / "mods");
        fs::copy(fs::path(TREMBLER_SOURCE_DIR) / "mods/wind", folder / "mods/wind",
                 fs::copy_options::recursive);
    }
    [[nodiscard]] std::unique_ptr<Player> enter() const {
        std::vector<fs::path> const places{folder / "mods"};
        auto player =
            std::make_unique<Player>(render::Size{1280, 720}, folder / "profile.json", levelsFolder(),
                                     nullptr, budget::BudgetMode::Stopwatch{}, lua::listMods(places));
        player->clickItem("free play");
        player->frames(6);
        return player;
    }
    [[nodiscard]] static bool offers(Player& player, std::string const& part) {
        auto const slots = player.session().toolbox();
        return std::any_of(slots.begin(), slots.end(),
                           [&](ToolboxSlot const& slot) { return slot.part == part; });
    }

    fs::path const folder = testFolder() / "home";
};

TEST_F(FreePlayMods, PartsAreOfferedWorkAndAreThereAgain) {
    {
        auto const player = enter();
        ASSERT_NE(player->findPlay(), nullptr);
        ASSERT_TRUE(offers(*player, "fan"));
        expectTidy(*player, "with mods");
        player->key(SDLK_f, KMOD_LCTRL);
        player->frames(2);
        render::pushText(window(), "fan");
        player->frames(3);
        player->look("free-play-mods");
        player->drag(player->item("part fan"), player->at({-3, 0.4}));
        ASSERT_EQ(player->session().placed().size(), 1U);
        ASSERT_TRUE(player->session().place({"wooden ball", {-1.5, 0.2}, 0, ""}));
        player->play().worldChanged();
        Vec2 const before = player->session().world().find<Position>(player->session().objectOf(2))->value;
        player->key(SDLK_SPACE);
        player->simulate(120);
        Vec2 const after = player->session().world().find<Position>(player->session().objectOf(2))->value;
        EXPECT_GT(after.x, before.x + 0.1) << "the fan blows it away";
        player->key(SDLK_SPACE);
        player->app().showTitle();
        player->frames(2);
    }
    EXPECT_EQ(lua::modsNamedBy(folder / "free-play.json"), std::vector<std::string>{"wind"});
    {
        auto const player = enter();
        EXPECT_EQ(player->session().placed().size(), 2U);
        player->app().showTitle();
        player->open(folder / "free-play.json"); // like any level
        ASSERT_NE(player->findPlay(), nullptr);
        EXPECT_EQ(player->session().placed().size(), 2U);
    }
}

TEST_F(FreePlayMods, OneThatIsBrokenIsNamedAndLeftOutAndItsPartsWaitInTheBuild) {
    fs::path const part = folder / "mods/wind/parts/fan.json";
    {
        auto const player = enter();
        ASSERT_TRUE(player->session().place({"fan", {-3, 0.4}, 0, ""}));
        ASSERT_TRUE(player->session().place({"cork", {-2, 0.2}, 0, ""}));
    }
    fs::rename(part, folder / "fan.json");
    std::ofstream(part) << R"({"name": "fan", "properties": {"material": "cheese"}})";
    {
        auto const player = enter();
        ASSERT_NE(player->findPlay(), nullptr);
        EXPECT_FALSE(offers(*player, "fan"));
        EXPECT_TRUE(offers(*player, "lamp"));
        EXPECT_EQ(player->session().placed().size(), 1U);
        EXPECT_GE(player->app().context().toasts.troubles(), 1);
        player->look("free-play-broken-mod");
        EXPECT_TRUE(lua::modsNamedBy(folder / "free-play.json").empty());
        ASSERT_TRUE(player->session().place({"lamp", {1, 1}, 0, ""}));
    }
    fs::rename(folder / "fan.json", part);
    auto const player = enter();
    EXPECT_TRUE(offers(*player, "fan"));
    EXPECT_EQ(player->session().placed().size(), 3U);
}

} // namespace
} // namespace free_play_mods_test
} // namespace trembler::ui::test
