// The inspector's button that asks for the cause of its object's state, with real input events.
#include "game/ui/app/menu/settings_page.hpp"
#include "game/ui/play/why/why_panel.hpp"
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/tidy.hpp"

namespace trembler::ui::test {
namespace inspector_why_test {
namespace {

auto const experiment = levelsFolder() / "experiments/1-switched-electromagnet.json";

Point placeOfMagnet(Player& player) {
    World const& world = player.session().world();
    return player.at(world.find<Position>(world.store().find("electromagnet"))->value);
}

/// Opens the inspector on the electromagnet of a paused run.
void inspectMagnet(Player& player) {
    player.open(experiment);
    player.key(SDLK_SPACE);
    player.simulate(64);
    player.key(SDLK_p);
    player.click(placeOfMagnet(player));
    player.frames(3);
    ASSERT_TRUE(player.showsCard("inspector"));
}

std::vector<std::string> answered(Player& player) {
    player.play().why().wait();
    player.frames(3);
    return player.play().why().lines();
}

TEST(InspectorWhy, GivesTheAnswerThatTheKeyGives) {
    Player player;
    inspectMagnet(player);
    player.look("why-inspector");
    player.clickItem("why object");
    std::vector<std::string> const byMouse = answered(player);
    ASSERT_FALSE(byMouse.empty());
    EXPECT_TRUE(player.showsCard("why"));
    EXPECT_FALSE(player.showsCard("inspector")) << "the answer stands in its place";
    expectTidy(player, "asked by mouse");
    player.clickItem("close why");
    player.moveTo(placeOfMagnet(player));
    player.frames(2);
    player.key(SDLK_y);
    EXPECT_EQ(answered(player), byMouse);
}

/// Clicks on an object of a run that goes on, and asks why; the words of the answer in one line.
std::string askedWhileItRuns(Player& player, std::string const& object) {
    World const& world = player.session().world();
    EXPECT_EQ(player.session().mode(), SessionMode::running);
    player.click(player.at(world.find<Position>(world.store().find(object))->value));
    player.frames(2);
    EXPECT_TRUE(player.showsCard("inspector")) << object;
    player.clickItem("why object");
    std::string all;
    for (std::string const& line : answered(player)) {
        all += line + " ";
    }
    EXPECT_EQ(player.session().mode(), SessionMode::running) << "it goes on meanwhile";
    return all;
}

TEST(InspectorWhy, AsksAboutALitLampWhileItRuns) {
    Player player;
    player.open(levelsFolder() / "2-electricity/1-both-gaps.json");
    player.session().load(*player.session().level().findSolution("a bar and a spanner"));
    player.key(SDLK_SPACE);
    player.simulate(100);
    std::string const answer = askedWhileItRuns(player, "road lamp");
    EXPECT_NE(answer.find("The road lamp is lit."), std::string::npos) << answer;
    EXPECT_NE(answer.find("ou laid"), std::string::npos) << answer;
}

TEST(InspectorWhy, AsksAboutARingingBellWhileItRuns) {
    Player player;
    player.open(levelsFolder() / "experiments/2-doorbell.json");
    player.key(SDLK_SPACE);
    player.simulate(150);
    std::string const answer = askedWhileItRuns(player, "bell");
    EXPECT_NE(answer.find("touches the bell"), std::string::npos) << answer;
    EXPECT_NE(answer.find("striker"), std::string::npos) << answer;
}

TEST(InspectorWhy, NeedsARun) {
    Player player;
    player.open(experiment);
    player.frames(2);
    player.click(placeOfMagnet(player));
    player.frames(3);
    ASSERT_TRUE(player.showsCard("inspector"));
    EXPECT_FALSE(player.shows("why object")) << "nothing has happened yet";
}

TEST(InspectorWhy, FitsInEveryWindowInGerman) {
    for (render::Size const size :
         {render::Size{800, 600}, render::Size{1280, 720}, render::Size{3840, 2160}}) {
        Player player(size);
        changeSettings(player.app().context(), {.reducedMotion = true, .language = "de"});
        inspectMagnet(player);
        auto const card = player.layout().card("inspector");
        auto const button = player.layout().item("why object");
        auto const close = player.layout().item("close inspector");
        ASSERT_TRUE(card && button && close) << size.width;
        EXPECT_TRUE(card->contains(button->low) && card->contains(button->high)) << size.width;
        EXPECT_FALSE(button->overlaps(*close)) << size.width;
        expectTidy(player, "inspector at " + std::to_string(size.width));
        player.look("why-inspector-" + std::to_string(size.width));
    }
}

} // namespace
} // namespace inspector_why_test
} // namespace trembler::ui::test
