// Views of a running world, with real input events: the inspector, panels, overlays, hints, clips and
// pictures.
#include "tests/game/ui/player.hpp"
#include "tests/support/read_png.hpp"

namespace trembler::ui::test {
namespace play_screen_looking_test {
namespace {

auto const firstContact = levelsFolder() / "first/1-first-contact.json";
auto const experiment = levelsFolder() / "experiments/1-switched-electromagnet.json";

TEST(Running, TheInspectorShowsEveryProperty) {
    Player player;
    player.open(experiment);
    player.key(SDLK_SPACE);
    player.simulate(120);
    player.key(SDLK_p);
    World const& world = player.session().world();
    ObjectId const magnet = world.store().find("electromagnet");
    player.click(player.at({1.8, 1.7}));
    player.frames(3);
    ASSERT_TRUE(player.showsCard("inspector"));
    EXPECT_EQ(player.play().inspector().name(), "electromagnet");
    std::vector<std::string> titles;
    std::string all;
    for (InspectorSection const& section : player.play().inspector().shown()) {
        titles.push_back(section.title);
        for (InspectorRow const& row : section.rows) {
            all += row.name + "=" + row.value + " " + row.unit + "\n";
        }
    }
    for (ColumnBase const* column : world.store().columns()) {
        if (column->has(magnet)) {
            EXPECT_NE(std::find(titles.begin(), titles.end(), column->info().text.name), titles.end())
                << column->info().text.name << " is missing";
        }
    }
    EXPECT_NE(all.find("strength=150000 A m"), std::string::npos) << all;
    EXPECT_NE(all.find("electricity=on"), std::string::npos) << all;
    EXPECT_NE(all.find("touches=metal object"), std::string::npos) << all;
    EXPECT_NE(all.find("magnetic force="), std::string::npos) << all;
    player.clickItem("close inspector");
    player.frames(2);
    EXPECT_FALSE(player.showsCard("inspector"));
}

TEST(Running, TheComponentsPanelIsOpenedAndClosed) {
    Player player;
    player.open(experiment);
    player.key(SDLK_c);
    player.frames(2);
    EXPECT_TRUE(player.showsCard("components"));
    player.key(SDLK_F3);
    player.frames(2);
    EXPECT_FALSE(player.showsCard("components"));
    player.clickItem("components");
    player.frames(2);
    EXPECT_TRUE(player.showsCard("components"));
    std::vector<std::string> effects;
    for (EffectLevels const& levels : effectLevels(player.session().world())) {
        effects.push_back(levels.effect);
        EXPECT_GE(levels.levels.size(), 2U);
    }
    EXPECT_NE(std::find(effects.begin(), effects.end(), "electricity"), effects.end());
    EXPECT_NE(std::find(effects.begin(), effects.end(), "gravity"), effects.end());
}

TEST(Running, ClipsAndPicturesAreWrittenWithoutTheInterface) {
    Player player;
    std::filesystem::remove_all(player.films());
    player.open(experiment);
    player.key(SDLK_SPACE);
    player.frames(2);
    player.key(SDLK_r);
    EXPECT_TRUE(player.play().commands().on(player.play().commands().indexOf("record")));
    auto const first = player.session().world().frame();
    player.frames(8);
    player.look("recording-720");
    player.key(SDLK_r);
    EXPECT_GE(player.session().world().frame(), first + 8);
    EXPECT_TRUE(std::filesystem::exists(player.films() / "clip-1.webp"));
    player.key(SDLK_p);
    player.key(SDLK_F12);
    ASSERT_TRUE(std::filesystem::exists(player.films() / "picture-1.png"));
    auto const image = render::readPng(player.films() / "picture-1.png");
    ASSERT_EQ(image.size(), (render::Size{1280, 720}));
    render::Image const screen = player.look("picture-720");
    Point const goals = player.layout().card("goal")->middle();
    auto const x = static_cast<int>(goals.x);
    int different = 0;
    for (int y = static_cast<int>(goals.y) - 30; y < static_cast<int>(goals.y) + 30; ++y) {
        different += image.at(x, y) == screen.at(x, y) ? 0 : 1;
    }
    EXPECT_GT(different, 20) << "no card lies over the world";
    auto const column = static_cast<int>(player.layout().card("goal")->low.x) + 40;
    for (int y = 24; y < 100; ++y) {                 // not even a card's shadow: paper is light
        EXPECT_GT(image.at(column, y)[0], 192) << y; // a shadow is at 186
    }
    player.clickItem("picture");
    EXPECT_TRUE(std::filesystem::exists(player.films() / "picture-2.png"));
}

TEST(Running, HintsComeOneAtATime) {
    Player player;
    player.open(firstContact);
    EXPECT_EQ(player.play().hintsShown(), 0U);
    player.key(SDLK_h);
    EXPECT_EQ(player.play().hintsShown(), 1U);
    player.frames(2); // the card grows
    player.clickItem("hint");
    EXPECT_EQ(player.play().hintsShown(), 2U);
    for (int i = 0; i < 9; ++i) {
        player.key(SDLK_h);
    }
    EXPECT_EQ(player.play().hintsShown(), player.session().level().hints.size());
}

TEST(Running, OverlaysAreToggledByKeyAndButton) {
    Player player;
    player.open(experiment);
    player.key(SDLK_1);
    EXPECT_TRUE(player.play().shown().electricity);
    player.key(SDLK_2);
    EXPECT_TRUE(player.play().shown().magnetism);
    player.key(SDLK_3);
    EXPECT_TRUE(player.play().shown().contacts);
    for (char const* name : {"electricity", "magnetism", "contacts"}) {
        player.clickItem(name);
    }
    EXPECT_FALSE(player.play().shown().electricity || player.play().shown().magnetism ||
                 player.play().shown().contacts);
}

} // namespace
} // namespace play_screen_looking_test
} // namespace trembler::ui::test
