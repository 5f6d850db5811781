// The seal of a success stands on its card from the first picture on.
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/player.hpp"

#include <algorithm>
#include <utility>

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

/// Pixels, the width of the seal in the first picture that shows it whole and thirty pictures later.
std::pair<float, float> sealWidths(bool reducedMotion) {
    Player player;
    Settings settings = player.app().context().profile.settings();
    settings.reducedMotion = reducedMotion;
    player.app().context().profile.setSettings(settings);
    player.drawEveryPicture();
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    player.key(SDLK_SPACE);
    auto const width = [] {
        auto const& corners = ImGui::GetForegroundDrawList()->VtxBuffer;
        auto const [low, high] =
            std::minmax_element(corners.begin(), corners.end(),
                                [](ImDrawVert const& a, ImDrawVert const& b) { return a.pos.x < b.pos.x; });
        return corners.empty() ? 0 : high->pos.x - low->pos.x;
    };
    for (int i = 0; i < 600 && width() <= 0; ++i) {
        player.frame();
    }
    float const first = width();
    player.frames(30);
    return {first, width()};
}

TEST(SuccessCard, MovesItsSealOnlyIfThingsMayMove) {
    auto const [stillFirst, stillLast] = sealWidths(true);
    EXPECT_GT(stillLast, 0);
    EXPECT_NEAR(stillFirst, stillLast, 0.01);
    auto const [first, last] = sealWidths(false);
    EXPECT_GT(first, 1.2F * last) << "it is pressed on";
    EXPECT_NEAR(last, stillLast, 0.01);
}

} // namespace
} // namespace trembler::ui::test
