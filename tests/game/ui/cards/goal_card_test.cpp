// The card of the goals: no number is broken across lines, and its heading does not scroll away.
#include "game/ui/app/menu/settings_page.hpp"
#include "game/ui/shared/texts.hpp"
#include "tests/game/ui/drawn_text.hpp"
#include "tests/game/ui/player.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace goal_card_test {
namespace {

void expectWholeNumbers(std::string const& where) {
    std::vector<DrawnText> const texts = drawnTexts();
    for (std::size_t i = 0; i < texts.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_FALSE(breaksANumber(texts[j], texts[i]))
                << where << ": \"" << texts[j].text << "\" | \"" << texts[i].text << "\"";
        }
    }
}

TEST(GoalCard, BreaksNoNumberOfAnyLevel) {
    for (char const* const language : {"en", "de"}) {
        Player player;
        changeSettings(player.app().context(), {.reducedMotion = true, .language = language});
        for (auto const& file : std::filesystem::recursive_directory_iterator(levelsFolder())) {
            std::string const name = file.path().filename().string();
            bool const level =
                file.path().extension() == ".json" && name.front() >= '0' && name.front() <= '9';
            if (!level) {
                continue;
            }
            player.open(file.path());
            player.frames(4);
            expectWholeNumbers(name + ", building");
            player.key(SDLK_SPACE);
            player.frames(4);
            expectWholeNumbers(name + ", running");
        }
    }
    useLanguage("en");
}

TEST(GoalCard, KeepsItsHeadingWhileItsContentScrolls) {
    Player player;
    changeSettings(player.app().context(), {.uiScale = 1.6F, .reducedMotion = true, .language = "en"});
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.frames(4);
    player.clickItem("story"); // hidden at first, as there is little room
    player.frames(8);
    auto const headingOf = [](std::vector<DrawnText> const& texts) {
        return std::find_if(texts.begin(), texts.end(),
                            [](DrawnText const& text) { return text.text == "First contact"; });
    };
    player.moveTo(player.layout().card("goal")->middle());
    double top = -1;
    for (int notches : {30, -30}) {
        player.wheel(notches);
        player.frames(4);
        std::vector<DrawnText> const texts = drawnTexts();
        EXPECT_TRUE(std::any_of(texts.begin(), texts.end(), [](DrawnText const& text) {
            return text.scrolled && text.window.starts_with("goal");
        })) << "the card has too much room for this test";
        auto const heading = headingOf(texts);
        ASSERT_NE(heading, texts.end());
        EXPECT_FALSE(heading->cutAlong);
        EXPECT_TRUE(top < 0 || heading->top == top);
        top = heading->top;
    }
    window().setUiScaleRequest(1.F);
}

} // namespace
} // namespace goal_card_test
} // namespace trembler::ui::test
