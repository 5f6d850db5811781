// Every screen at every size of the window and of the letters: no words and no buttons lie on each other,
// nothing is outside the window, no letter is cut, no number is broken across lines.
#include "game/ui/app/settings_page.hpp"
#include "tests/game/ui/drawn_text.hpp"
#include "tests/game/ui/screen_walk.hpp"
#include "tests/game/ui/tidy.hpp"

#include <array>
#include <cmath>
#include <set>

namespace trembler::ui::test {
namespace {

Rect shrunk(Rect const& rect, double by) {
    return {rect.low + Point{by, by}, rect.high - Point{by, by}};
}

/// Tips and toasts lie over everything for a moment, by design.
bool liesOver(DrawnText const& text) {
    return text.window.starts_with("##Tooltip") || text.window == "##Foreground";
}

void expectReadable(std::string const& where) {
    render::Size const size = window().size();
    std::vector<DrawnText> const texts = drawnTexts();
    EXPECT_FALSE(texts.empty()) << where;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        DrawnText const& text = texts[i];
        bool const ofScene = text.window == "##Background"; // the scene may reach beyond the window
        EXPECT_TRUE(ofScene || (text.rect.low.x > -1 && text.rect.low.y > -1 &&
                                text.rect.high.x < size.width + 1 && text.rect.high.y < size.height + 1))
            << where << ": \"" << text.text << "\" leaves the window";
        // Fields of the editor's pages scroll with their cursor.
        bool const inField = text.window.starts_with("panel/");
        EXPECT_FALSE(!ofScene && !inField && text.cutAcross)
            << where << ": \"" << text.text << "\" is cut at a side";
        EXPECT_FALSE(!ofScene && !inField && text.cutAlong && !text.scrolled)
            << where << ": \"" << text.text << "\" is cut above or below";
        for (std::size_t j = 0; j < i && !liesOver(text); ++j) {
            if (texts[j].window != text.window) {
                continue;
            }
            EXPECT_FALSE(shrunk(text.rect, 1).overlaps(shrunk(texts[j].rect, 1)))
                << where << ": \"" << text.text << "\" lies on \"" << texts[j].text << "\"";
            EXPECT_FALSE(breaksANumber(texts[j], text))
                << where << ": a number is broken: \"" << texts[j].text << "\" | \"" << text.text << "\"";
        }
    }
}

/// Words whose middle is on a button do not reach beyond it.
void expectWordsFit(Player& player, std::string const& where) {
    for (DrawnText const& text : drawnTexts()) {
        for (Placed const& item : player.layout().items()) {
            bool const on = !liesOver(text) && text.window != "##Background" &&
                            item.rect.contains(text.rect.middle()) && item.name.find("part ") != 0;
            EXPECT_FALSE(on &&
                         (text.rect.low.x < item.rect.low.x - 1 || text.rect.high.x > item.rect.high.x + 1))
                << where << ": \"" << text.text << "\" reaches beyond \"" << item.name << "\"";
        }
    }
}

class Layouts : public testing::TestWithParam<render::Size> {
protected:
    ~Layouts() override { window().setUiScaleRequest(1.F); }
};

void setLetters(Player& player, float scale) {
    changeSettings(player.app().context(), {.uiScale = scale, .reducedMotion = true, .language = "en"});
}

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
    Player player(GetParam());
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
                         testing::Values(render::Size{800, 600}, render::Size{1024, 768},
                                         render::Size{1280, 720}, render::Size{1920, 1080},
                                         render::Size{2560, 1440}, render::Size{3840, 2160}),
                         [](auto const& info) {
                             return std::to_string(info.param.width) + "by" +
                                    std::to_string(info.param.height);
                         });

} // namespace
} // namespace trembler::ui::test
