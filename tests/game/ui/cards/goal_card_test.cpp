// The card of the goals: no number is broken across lines.
#include "game/ui/app/settings_page.hpp"
#include "game/ui/shared/texts.hpp"
#include "tests/game/ui/drawn_text.hpp"
#include "tests/game/ui/player.hpp"

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

} // namespace
} // namespace goal_card_test
} // namespace trembler::ui::test
