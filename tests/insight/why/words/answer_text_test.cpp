#include "insight/why/words/answer_text.hpp"
#include "insight/why/words/words.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace trembler::insight {
namespace {

TEST(AnswerText, TellsTheSameAfterwards) {
    LevelRuns const runs(gameData(), firstContact().level());
    Answer const answer = why(runs, *firstContact().level().findSolution("the spanner"), {});
    ASSERT_TRUE(answer.happened);
    std::string const text = toText(answer);
    EXPECT_EQ(text.find('\n'), std::string::npos) << "a line of a journal";
    Answer const again = answerFrom(text);
    EXPECT_EQ(toJson(again, "", "Light it", AnswerLanguage()),
              toJson(answer, "", "Light it", AnswerLanguage()));
    EXPECT_EQ(toText(again), text);
}

} // namespace
} // namespace trembler::insight
