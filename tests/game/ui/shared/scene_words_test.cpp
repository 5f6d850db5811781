// Words that the world's state puts beside objects.
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/player.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace scene_words_test {
namespace {

bool showsWords(std::string const& wanted) {
    std::vector<std::string> const lines = DrawnWords().lines();
    return std::find(lines.begin(), lines.end(), wanted) != lines.end();
}

// Nothing told a newcomer why everything was dark after a wire from one end of the battery to the other.
TEST(SceneWords, MarkAShortCircuitAtItsSource) {
    Player player({960, 540});
    player.open(dataFolder() / "short-circuit.json");
    player.key(SDLK_SPACE);
    player.simulate(16);
    player.look("no-short-circuit");
    EXPECT_FALSE(showsWords("Short circuit"));
    player.key(SDLK_SPACE);
    player.key(SDLK_w);
    player.click(player.at({-0.71, 0.12}));
    player.click(player.at({-1.29, 0.12}));
    ASSERT_EQ(player.session().wires().size(), 1U);
    player.key(SDLK_SPACE);
    player.simulate(16);
    player.look("short-circuit");
    EXPECT_TRUE(showsWords("Short circuit"));
    player.key(SDLK_k); // the past is marked like the present
    player.key(SDLK_PAGEUP);
    player.look("short-circuit-past");
    EXPECT_TRUE(player.play().timeline().looksBack());
    EXPECT_TRUE(showsWords("Short circuit"));
}

} // namespace
} // namespace scene_words_test
} // namespace trembler::ui::test
