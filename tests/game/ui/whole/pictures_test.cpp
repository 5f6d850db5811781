// Every screen at a small and at a large size: cards do not overlap, nothing is cut off; and a picture of
// each for people to look at.
#include "tests/game/ui/tidy.hpp"
#include "tests/support/read_png.hpp"

namespace trembler::ui::test {
namespace {

class Screens : public testing::TestWithParam<render::Size> {
protected:
    [[nodiscard]] std::string named(char const* what) const {
        return std::string(what) + "-" + std::to_string(GetParam().height);
    }
};

TEST_P(Screens, Title) {
    Player player(GetParam());
    player.frames(12);
    expectTidy(player, "title");
    player.look(named("title"));
}

TEST_P(Screens, Building) {
    Player player(GetParam());
    player.open(levelsFolder() / "first/1-first-contact.json");
    expectTidy(player, "building");
    player.look(named("building"));
    player.moveTo(player.item("part steel bar"));
    player.press();
    player.moveTo(player.at({-1.8, 1.5}));
    expectTidy(player, "carrying");
    player.look(named("carrying"));
    player.moveTo(player.at({1.7, 1.8}));
    player.look(named("carrying-badly"));
    player.moveTo(player.at({-1.8, 1.5}));
    player.release();
    player.key(SDLK_h);
    player.key(SDLK_h);
    player.key(SDLK_h);
    player.frames(2);
    expectTidy(player, "placed, with hints");
    player.look(named("placed"));
    player.key(SDLK_n);
    player.click(player.at({1.7, 1.7}));
    player.frames(4);
    expectTidy(player, "inspecting");
    player.look(named("inspecting"));
}

TEST_P(Screens, Running) {
    Player player(GetParam());
    player.open(levelsFolder() / "experiments/1-switched-electromagnet.json");
    player.key(SDLK_SPACE);
    player.simulate(64);
    expectTidy(player, "about to work");
    player.simulate(48);
    player.frames(4);
    expectTidy(player, "running");
    player.look(named("running"));
    player.key(SDLK_p);
    player.key(SDLK_1);
    player.look(named("electricity"));
    player.key(SDLK_1);
    player.key(SDLK_2);
    player.look(named("magnetism"));
    player.key(SDLK_2);
    player.key(SDLK_3);
    player.key(SDLK_c);
    player.click(player.at({1.8, 1.7}));
    player.frames(4);
    expectTidy(player, "components");
    player.look(named("components"));
}

TEST_P(Screens, Menus) {
    Player player(GetParam());
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.key(SDLK_ESCAPE);
    player.frames(3);
    expectTidy(player, "menu");
    player.look(named("menu"));
    player.clickItem("menu.settings");
    player.frames(3);
    expectTidy(player, "settings");
    player.look(named("settings"));
    player.key(SDLK_ESCAPE);
    player.frames(2);
    player.clickItem("menu.levels");
    player.frames(3);
    expectTidy(player, "level list");
    player.look(named("levels"));
    player.key(SDLK_ESCAPE);
    player.key(SDLK_ESCAPE);
    player.key(SDLK_F1);
    player.frames(3);
    expectTidy(player, "keys");
    player.look(named("keys"));
}

TEST_P(Screens, EveryLevel) {
    Player player(GetParam());
    for (CatalogGroup const& group : player.app().context().levels.groups()) {
        for (CatalogEntry const& entry : group.levels) {
            player.open(entry.file);
            ASSERT_NE(player.findPlay(), nullptr) << entry.id;
            expectTidy(player, entry.id);
            player.key(SDLK_SPACE);
            player.simulate(16);
            expectTidy(player, entry.id + " running");
            player.look(named(("level-" + entry.file.stem().string()).c_str()));
        }
    }
}

/// The pictures on the way from the title through two levels, if every picture is drawn or only these.
std::vector<render::Image> picturesOnTheWay(bool drawsAll) {
    Player player({960, 540});
    std::filesystem::remove_all(player.films());
    if (drawsAll) {
        player.drawEveryPicture();
    }
    std::vector<render::Image> pictures;
    auto const look = [&](std::string const& what) { pictures.push_back(player.look("on-the-way-" + what)); };
    player.frames(9);
    look("title");
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.5}));
    player.key(SDLK_q);
    look("placed");
    player.moveTo(player.item("part spanner"));
    player.press();
    player.moveTo(player.at({1.7, 1.8}));
    look("carried");
    player.release();
    player.key(SDLK_ESCAPE);
    player.open(levelsFolder() / "experiments/1-switched-electromagnet.json");
    player.key(SDLK_SPACE);
    player.simulate(64);
    player.frames(3);
    look("running");
    player.key(SDLK_F12); // saved by the game itself
    pictures.push_back(render::readPng(player.films() / "picture-1.png"));
    player.simulate(64);
    player.key(SDLK_1);
    player.key(SDLK_3);
    look("solved");
    player.click(player.at({1.8, 1.7}));
    player.frames(3);
    look("inspecting");
    player.key(SDLK_ESCAPE);
    player.key(SDLK_ESCAPE);
    player.frames(3);
    look("menu");
    return pictures;
}

TEST(UnseenPictures, DoNotInfluenceSeenOnes) {
    std::vector<render::Image> const all = picturesOnTheWay(true);
    std::vector<render::Image> const few = picturesOnTheWay(false);
    ASSERT_EQ(all.size(), few.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i], few[i]) << "picture " << i;
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_NE(all[i], all[j]) << "pictures " << i << " and " << j << " must differ";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Screens, testing::Values(render::Size{1280, 720}, render::Size{3840, 2160}),
                         [](auto const& info) { return "lines" + std::to_string(info.param.height); });

} // namespace
} // namespace trembler::ui::test
