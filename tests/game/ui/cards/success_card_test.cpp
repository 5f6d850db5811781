// The seal of a success stands on its card from the first picture on.
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/player.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace {

bool saysThatItWorks() {
    auto const lines = DrawnWords().lines();
    return std::any_of(lines.begin(), lines.end(),
                       [](std::string const& line) { return line.find("It works!") != std::string::npos; });
}

// The first card of a session that success opens is not seen before its size is known.
TEST(SuccessCard, HasItsSealNeverAlone) {
    Player player;
    player.drawEveryPicture();
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    player.key(SDLK_SPACE);
    int before = 0;
    int with = 0;
    for (int i = 0; i < 600 && with < 30; ++i) {
        player.frame();
        bool const seal = ImGui::GetForegroundDrawList()->VtxBuffer.Size > 0;
        before += player.session().solved() && !seal ? 1 : 0;
        with += seal ? 1 : 0;
        ASSERT_TRUE(!seal || saysThatItWorks()) << "picture " << i;
    }
    EXPECT_EQ(with, 30);
    EXPECT_LE(before, 3) << "the card comes at once";
}

} // namespace
} // namespace trembler::ui::test
