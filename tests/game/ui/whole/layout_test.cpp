// Every screen at every size of the window and of the letters: no words and no buttons lie on each other,
// nothing is outside the window, no letter is cut, no number is broken across lines.
#include "game/ui/app/menu/settings_page.hpp"
#include "game/ui/shared/texts.hpp"
#include "tests/game/ui/readable.hpp"
#include "tests/game/ui/screen_walk.hpp"
#include "tests/game/ui/tidy.hpp"

#include <array>
#include <cmath>
#include <tuple>

namespace trembler::ui::test {
namespace {

class Layouts : public testing::TestWithParam<std::tuple<render::Size, char const*>> {
protected:
    ~Layouts() override {
        window().setUiScaleRequest(1.F);
        useLanguage("en");
    }
    static render::Size size() { return std::get<0>(GetParam()); }
    static void setLetters(Player& player, float scale) {
        changeSettings(player.app().context(),
                       {.uiScale = scale, .reducedMotion = true, .language = std::get<1>(GetParam())});
    }
};

void expectInOrder(Player& player, std::string const& screen, float scale) {
    if (screen == "edit-letters") {
        return; // the keyboard lies over all else by design; LettersByPad.FitsIntoEverySize looks at it
    }
    render::Size const size = window().size();
    std::string const where = screen + " at " + std::to_string(size.width) + "x" +
                              std::to_string(size.height) + ", letters " +
                              std::to_string(std::lround(100 * scale)) + " %";
    expectTidy(player, where);
    expectReadable(where);
    expectWordsFit(player, where);
}

constexpr std::array scales{0.75F, 1.F, 1.35F, 1.6F};

TEST_P(Layouts, NothingOverlapsAndNothingIsCut) {
    Player player(size());
    for (float const scale : scales) {
        setLetters(player, scale);
        auto const look = [&](std::string const& screen) { expectInOrder(player, screen, scale); };
        walkMenus(player, look);
        walkLevel(player, look);
        walkOthers(player, look);
        walkEditorWithoutStudies(player, look);
    }
    // Studied once for all sizes of letters, as that takes longer than the rest.
    walkStudies(player, [&](std::string const& screen) {
        for (float const scale : scales) {
            setLetters(player, scale);
            player.frames(8); // until all cards know their size
            expectInOrder(player, screen, scale);
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Sizes, Layouts,
                         testing::Combine(testing::Values(render::Size{800, 600}, render::Size{1024, 768},
                                                          render::Size{1280, 720}, render::Size{1920, 1080},
                                                          render::Size{2560, 1440}, render::Size{3840, 2160}),
                                          testing::Values("en", "de")),
                         [](auto const& info) {
                             render::Size const size = std::get<0>(info.param);
                             return std::to_string(size.width) + "by" + std::to_string(size.height) +
                                    std::get<1>(info.param);
                         });

} // namespace
} // namespace trembler::ui::test
