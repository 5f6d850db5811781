// The messages to the player when a level is opened.
#include "game/ui/play/play_parts.hpp"
#include "game/ui/shared/texts.hpp"
#include "tests/game/ui/player.hpp"
#include "tests/support/boxes.hpp"

#include <fstream>

namespace trembler::ui::test {
namespace play_parts_test {
namespace {

/// A file with a level of so many boxes in one place, or side by side.
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

} // namespace
} // namespace play_parts_test
} // namespace trembler::ui::test
