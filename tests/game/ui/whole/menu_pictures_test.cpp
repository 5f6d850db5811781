// The title and every page of the menu, from small to large windows, with small and with large letters, in
// every language: nothing overlaps, nothing is cut off; and a picture of each for people to look at.
#include "game/ui/app/menu/settings_page.hpp"
#include "game/ui/app/title/title_screen.hpp"
#include "game/ui/shared/texts.hpp"
#include "tests/game/ui/tidy.hpp"

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

namespace trembler::ui::test {
namespace {

struct PageLook {
    render::Size size;
    float scale;
    char const* language;
};

class MenuPages : public testing::TestWithParam<PageLook> {
protected:
    MenuPages() : player(GetParam().size) {
        changeSettings(player.app().context(),
                       {.uiScale = GetParam().scale, .language = GetParam().language});
        player.frames(12);
    }
    ~MenuPages() override {
        window().setUiScaleRequest(1.F);
        useLanguage("en");
    }

    void look(std::string const& page) {
        player.frames(12);
        expectTidy(player, page);
        if (std::getenv("TREMBLER_PICTURES") != nullptr) {
            player.frames(20); // until the levels' pictures are there
            player.look("page-" + page + "-" + std::to_string(GetParam().size.height) + "-" +
                        std::to_string(std::lround(100 * GetParam().scale)) + "-" + GetParam().language);
        }
    }
    void lookAtMenu(std::string const& page, MenuPage which) {
        player.app().show(std::make_unique<TitleScreen>(player.app().context()));
        player.frames(2);
        player.app().openMenu(which);
        look(page);
        player.key(SDLK_ESCAPE);
    }

    Player player;
};

TEST_P(MenuPages, AreTidy) {
    look("title");
    lookAtMenu("levels", MenuPage::levels);
    lookAtMenu("gallery", MenuPage::gallery);
    lookAtMenu("settings", MenuPage::settings);
    lookAtMenu("bindings", MenuPage::keys);
    lookAtMenu("help", MenuPage::help);
    lookAtMenu("ending", MenuPage::ending);
    lookAtMenu("menu", MenuPage::main);
}

INSTANTIATE_TEST_SUITE_P(Looks, MenuPages,
                         testing::Values(PageLook{{800, 600}, 1.F, "en"}, PageLook{{800, 600}, 1.6F, "de"},
                                         PageLook{{1280, 720}, 1.F, "de"}, PageLook{{1280, 720}, 1.6F, "en"},
                                         PageLook{{2560, 1440}, 1.F, "en"},
                                         PageLook{{2560, 1440}, 1.6F, "de"}),
                         [](auto const& info) {
                             return std::to_string(info.param.size.height) + "at" +
                                    std::to_string(std::lround(100 * info.param.scale));
                         });

} // namespace
} // namespace trembler::ui::test
