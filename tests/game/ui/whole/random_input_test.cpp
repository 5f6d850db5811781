// Some scenes of random input, the same in every run; sweep_input plays any number of them.
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/random/random_player.hpp"
#include "tests/support/sanitizer.hpp"

namespace trembler::ui::test {
namespace {

TEST(RandomInput, DoesNoHarmToTheProgramOrItsFiles) {
    int const acts = trembler::test::underSanitizer ? 20 : 60;
    std::vector<std::string> done;
    for (std::uint64_t const seed : {1U, 2U, 3U}) {
        RandomPlayer player(window(), gameData(), testFolder() / "player", seed);
        done.clear();
        try {
            for (int i = 0; i < acts; ++i) {
                done.push_back(player.act());
            }
            player.end();
        } catch (std::exception const& error) {
            ADD_FAILURE() << "seed " << seed << ", after \"" << (done.empty() ? "" : done.back())
                          << "\": " << error.what();
        }
        EXPECT_EQ(player.faultsOfFiles(), std::vector<std::string>{}) << "seed " << seed;
        EXPECT_GT(player.seen().size(), 20U) << "most events miss, so nothing is tried";
    }
}

TEST(RandomInput, IsTheSameForTheSameSeed) {
    std::vector<std::string> first;
    std::vector<std::string> again;
    for (auto* const done : {&first, &again}) {
        RandomPlayer player(window(), gameData(), testFolder() / "player", 5);
        for (int i = 0; i < 25; ++i) {
            done->push_back(player.act());
        }
    }
    EXPECT_EQ(first, again);
}

} // namespace
} // namespace trembler::ui::test
