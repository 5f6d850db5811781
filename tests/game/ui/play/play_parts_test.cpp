// The messages to the player when a level is opened, and about its frames.
#include "game/ui/play/play_parts.hpp"
#include "game/ui/shared/texts.hpp"
#include "tests/game/ui/player.hpp"
#include "tests/support/boxes.hpp"

#include <fstream>

namespace trembler::ui::test {
namespace play_parts_test {
namespace {

/// A file with a level of that many boxes in one place, or side by side.
std::filesystem::path boxes(int count, double apart) {
    auto const file = testFolder() / "boxes.json";
    std::ofstream(file) << trembler::test::levelOfBoxes(count, apart);
    return file;
}

TEST(OpenedLevel, OfACrowdIsSaidToBeSlow) {
    Player player;
    player.open(boxes(300, 0)); // 300 x 299 / 2 pairs
    std::string const told = player.app().context().toasts.newest();
    EXPECT_NE(told.find("44850 pairs"), std::string::npos) << told;
    EXPECT_NE(told.find("box "), std::string::npos) << "it names a body: " << told;
    EXPECT_EQ(player.session().world().frame(), 0U);
    player.look("crowd-told");
}

TEST(OpenedLevel, OfACrowdIsSaidToBeSlowInThePlayersLanguage) {
    Player player;
    useLanguage("de");
    player.open(boxes(300, 0));
    std::string const told = player.app().context().toasts.newest();
    useLanguage("en");
    EXPECT_NE(told.find("44850 Paare von St"), std::string::npos) << told;
}

TEST(OpenedLevel, OfBoxesSideBySideSaysNothing) {
    Player player;
    player.open(boxes(300, 0.2));
    EXPECT_EQ(player.app().context().toasts.count(), 0U) << player.app().context().toasts.newest();
}

TEST(OpenedLevel, TellsOfEverySlowFrameInThePlayersLanguage) {
    Player player;
    player.open(boxes(3, 0.2));
    render::Toasts const& toasts = player.app().context().toasts;
    player.play().run().step();
    EXPECT_EQ(toasts.count(), 0U) << toasts.newest();
    double now = 0; // between two readings 2.5 s pass
    player.play().run().measureWith(FrameTimer(slowAfter, [&] { return now += 2.5; }));
    player.play().run().step();
    EXPECT_TRUE(toasts.newest().starts_with("Frame 2 took 2.5 s of processor time, most of it in "))
        << toasts.newest();
    useLanguage("de");
    player.play().run().step();
    std::string const told = toasts.newest();
    useLanguage("en");
    EXPECT_TRUE(told.starts_with("Bild 3 brauchte 2,5 s Rechenzeit, das meiste davon für ")) << told;
}

} // namespace
} // namespace play_parts_test
} // namespace trembler::ui::test
