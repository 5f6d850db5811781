#include "insight/why/story/fold_repeats.hpp"
#include "insight/why/words/words.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace fold_repeats_test {
namespace {

ChainStep step(StepKind kind, std::string const& object, std::vector<std::size_t> because) {
    ChainStep made;
    made.step.kind = kind;
    made.step.objects = {object};
    made.step.because = std::move(because);
    made.proof = Proof::confirmed;
    return made;
}

/// A switch, then current and magnet in turn, that many times, then a bell.
std::vector<ChainStep> doorbell(std::size_t times) {
    std::vector<ChainStep> chain{step(StepKind::placed, "switch", {})};
    for (std::size_t i = 0; i < times; ++i) {
        chain.push_back(step(StepKind::on, "coil", {chain.size() - 1}));
        chain.push_back(step(StepKind::magnetOn, "coil", {chain.size() - 1}));
        chain.back().step.frame = chain.size();
    }
    chain.push_back(step(StepKind::pull, "striker", {chain.size() - 1}));
    chain.back().step.objects.emplace_back("coil");
    return chain;
}

TEST(FoldRepeats, KeepsTheLastTimeAndWhatLedToTheFirst) {
    std::vector<ChainStep> chain = doorbell(40);
    foldRepeats(chain, {});
    ASSERT_EQ(chain.size(), 4U);
    EXPECT_EQ(chain[1].times, 40U);
    EXPECT_EQ(chain[2].times, 40U);
    EXPECT_EQ(chain[1].cycle, chain[2].cycle);
    EXPECT_EQ(chain[2].step.frame, 81U) << "of the last time";
    EXPECT_EQ(chain[1].step.because, std::vector<std::size_t>{0}) << "in the end because of the switch";
    EXPECT_EQ(chain[2].step.because, std::vector<std::size_t>{1});
    EXPECT_EQ(chain[3].step.because, std::vector<std::size_t>{2});
    EXPECT_EQ(chain[3].times, 1U);
    Answer answer;
    answer.happened = true;
    answer.chain = chain;
    EXPECT_EQ(
        sentencesOf(answer, "", AnswerLanguage()),
        std::vector<std::string>{"The coil pulls the striker, because the coil becomes magnetic, because "
                                 "current flows through the coil, because you laid the switch there before "
                                 "the start (and so on, 40 times)."});
}

TEST(FoldRepeats, LeavesWhatHappensTwiceAndWhatThePlayerDid) {
    std::vector<ChainStep> twice = doorbell(2);
    foldRepeats(twice, {});
    EXPECT_EQ(twice.size(), 6U);
    std::vector<ChainStep> grabs;
    for (std::size_t i = 0; i < 5; ++i) {
        grabs.push_back(step(StepKind::grabbed, "crank", {}));
    }
    foldRepeats(grabs, {});
    EXPECT_EQ(grabs.size(), 5U);
}

// A contact touches one spoke after the other, and switches a coil each time.
TEST(FoldRepeats, TakesWhatHasTheSameRoleForTheSame) {
    auto const turns = [](std::size_t count) {
        std::vector<ChainStep> chain;
        for (std::size_t i = 0; i < count; ++i) {
            chain.push_back(step(StepKind::contact, "contact", {}));
            chain.back().step.objects.push_back("spoke " + std::to_string(i));
            if (i > 0) {
                chain.back().step.because = {chain.size() - 2};
            }
            chain.push_back(step(StepKind::on, "coil", {chain.size() - 1}));
        }
        return chain;
    };
    SceneFacts facts;
    for (std::size_t i = 0; i < 4; ++i) {
        facts.roles["spoke " + std::to_string(i)] = 1;
    }
    facts.roles["spoke 4"] = 2;
    std::vector<ChainStep> chain = turns(4);
    foldRepeats(chain, facts);
    ASSERT_EQ(chain.size(), 2U);
    EXPECT_EQ(chain[0].times, 4U);
    EXPECT_EQ(chain[0].step.objects.back(), "spoke 3") << "of the last time";
    chain = turns(5);
    foldRepeats(chain, facts);
    EXPECT_EQ(chain.size(), 4U) << "the last spoke has another role";
    chain = turns(4);
    foldRepeats(chain, {});
    EXPECT_EQ(chain.size(), 8U) << "without roles each spoke is another one";
}

} // namespace
} // namespace fold_repeats_test
} // namespace trembler::insight
