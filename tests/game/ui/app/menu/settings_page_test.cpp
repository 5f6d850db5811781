// Changes of the settings are visible at once.
#include "game/ui/app/menu/settings_page.hpp"
#include "render/draw/palette.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace {

/// Whether some pixel has approximately that colour.
bool hasColour(render::Image const& image, render::Colour colour) {
    for (int y = 0; y < image.size().height; ++y) {
        for (int x = 0; x < image.size().width; ++x) {
            auto const pixel = image.at(x, y);
            int const off = std::abs(pixel[0] - colour.red) + std::abs(pixel[1] - colour.green) +
                            std::abs(pixel[2] - colour.blue);
            if (off < 6) {
                return true;
            }
        }
    }
    return false;
}

TEST(SettingsPage, ColoursChangeInTheWholeWindow) {
    using render::palette::meanings;
    Player player;
    player.clickItem("settings");
    player.frames(3);
    EXPECT_TRUE(hasColour(player.look("settings-usual"), meanings[0].accent));
    player.clickItem("clear colours");
    player.frames(3);
    EXPECT_EQ(render::palette::inUse(), render::palette::Choice::clear);
    EXPECT_TRUE(player.app().context().profile.settings().clearColours);
    auto const clear = player.look("settings-clear");
    EXPECT_TRUE(hasColour(clear, meanings[1].accent));
    EXPECT_FALSE(hasColour(clear, meanings[0].accent)) << "nothing keeps the other colours";
    player.clickItem("usual colours");
    player.frames(3);
    EXPECT_EQ(render::palette::inUse(), render::palette::Choice::usual);
}

} // namespace
} // namespace trembler::ui::test
