// The force that a push button lacks: by hand from its spring, its weight and its way, and as it is told.
#include "insight/why/runs/not_pushed.hpp"
#include "insight/why/words/words.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace trembler::insight {
namespace not_pushed_test {
namespace {

// Of the part "push switch": N/m; m of the spring at rest, and when the button is up; kg; m to the contacts.
constexpr double buttonForce = 40 * (0.39 - 0.16 + 0.05) - (0.5 + 0.2) * 9.81;

Answer whyNot(Solution const& solution) {
    LevelFile const level = loadLevel(gameData().registry, testedFile("2-electricity/3-two-buttons.json"));
    LevelRuns const runs(gameData(), level);
    AskOptions options;
    options.frames = 400;
    options.threads = 2;
    return why(runs, solution, {}, options);
}

std::vector<Miss> pushesIn(Answer const& answer) {
    std::vector<Miss> pushes;
    if (answer.nearest) {
        for (Miss const& other : answer.nearest->nearest.besides) {
            if (other.lack == Lack::unpushed || other.lack == Lack::push) {
                pushes.push_back(other);
            }
        }
    }
    return pushes;
}

TEST(NotPushed, TellsTheForceThatEachButtonLacks) {
    Answer const answer = whyNot({});
    ASSERT_FALSE(answer.happened);
    std::vector<Miss> const pushes = pushesIn(answer);
    ASSERT_EQ(pushes.size(), 2U);
    std::vector<std::string> names;
    for (Miss const& push : pushes) {
        EXPECT_EQ(push.lack, Lack::unpushed);
        EXPECT_NEAR(push.by, buttonForce, 0.15);
        names.insert(names.end(), push.names.begin(), push.names.end());
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"left button button", "right button button"}));
    EXPECT_EQ(pushes.back().ifClosed, IfClosed::met) << "only with both";
    EXPECT_EQ(pushes.front().ifClosed, IfClosed::unknown);
    std::vector<std::string> const told = sentencesOf(answer, "Light it", AnswerLanguage());
    EXPECT_TRUE(std::any_of(told.begin(), told.end(), [](std::string const& sentence) {
        return sentence.starts_with("Nothing pushed the left button button: a push of 4.3");
    })) << told.back();
    EXPECT_EQ(told.back(), "Pushed so, the goal would have been met.");
}

TEST(NotPushed, IsAboutTheOtherButtonIfOneIsPressed) {
    Solution const crate = placing("crate", {-1.38, 2.2});
    std::vector<Miss> const pushes = pushesIn(whyNot(crate));
    ASSERT_EQ(pushes.size(), 1U);
    EXPECT_EQ(pushes.front().names, std::vector<std::string>{"right button button"});
    EXPECT_EQ(pushes.front().ifClosed, IfClosed::met);
}

// What lies on it is too light, and counts.
TEST(NotPushed, TellsHowMuchMoreIsNeeded) {
    std::ifstream stored(testedFile("2-electricity/3-two-buttons.json"));
    std::string text{std::istreambuf_iterator<char>(stored), {}};
    std::string const begin = "\"objects\": [";
    text.insert(text.find(begin) + begin.size(),
                R"({"name": "weight", "at": [1.38, 1.8], "properties": {"mass": 0.3, "restitution": 0,
                    "shape": [{"form": "box", "width": 0.2, "height": 0.2}]}},)");
    LevelRuns const runs(gameData(),
                         readLevel(gameData().registry, JsonDocument::parse(text, "buttons.json")));
    AskOptions options;
    options.frames = 400;
    Answer const answer = why(runs, placing("crate", {-1.38, 2.2}), {}, options);
    std::vector<Miss> const pushes = pushesIn(answer);
    ASSERT_EQ(pushes.size(), 1U);
    EXPECT_EQ(pushes.front().lack, Lack::push);
    EXPECT_NEAR(pushes.front().by, buttonForce - 0.3 * 9.81, 0.1);
    EXPECT_EQ(pushes.front().ifClosed, IfClosed::met);
}

TEST(NotPushed, SaysNothingOfFixedContacts) {
    AskOptions options;
    options.frames = 100;
    LevelRuns const runs(gameData(), firstContact().level());
    EXPECT_TRUE(pushesIn(why(runs, {}, {}, options)).empty());
}

} // namespace
} // namespace not_pushed_test
} // namespace trembler::insight
