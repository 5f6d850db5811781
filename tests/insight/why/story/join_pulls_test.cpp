#include "insight/why/story/join_pulls.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace join_pulls_test {
namespace {

ChainStep pull(std::string const& object, std::string const& magnet, std::uint64_t frame) {
    ChainStep made;
    made.step.kind = StepKind::pull;
    made.step.frame = frame;
    made.step.objects = {object, magnet};
    made.proof = Proof::confirmed;
    return made;
}

ChainStep contact(std::vector<std::size_t> because) {
    ChainStep made;
    made.step.kind = StepKind::contact;
    made.step.frame = 90;
    made.step.because = std::move(because);
    return made;
}

using Because = std::vector<std::size_t>;

TEST(JoinPulls, KeepsThePullOfTheLastEffect) {
    SceneFacts facts;
    facts.roles = {{"spoke 1", 1}, {"spoke 2", 1}, {"spoke 3", 1}, {"spoke 4", 2}};
    std::vector<ChainStep> chain{pull("spoke 1", "base", 1),
                                 pull("spoke 2", "base", 1),
                                 pull("spoke 3", "coil", 1),
                                 pull("spoke 4", "base", 1),
                                 pull("spoke 3", "base", 7),
                                 contact({1, 2}),
                                 contact({0, 5}),
                                 contact({3, 4, 6})};
    joinPulls(chain, facts);
    ASSERT_EQ(chain.size(), 7U) << "another magnet, another role and another frame are told";
    EXPECT_EQ(chain[0].step.objects.front(), "spoke 1") << "from which the later contact follows";
    EXPECT_EQ(chain[1].step.objects.back(), "coil");
    EXPECT_EQ(chain[4].step.because, (Because{0, 1})) << "what followed from the other follows from it";
    EXPECT_EQ(chain[5].step.because, (Because{0, 4}));
    EXPECT_EQ(chain[6].step.because, (Because{2, 3, 5}));
}

TEST(JoinPulls, LeavesPullsOnUnlikeObjects) {
    std::vector<ChainStep> chain{pull("ball", "magnet", 1), pull("key", "magnet", 1), contact({0, 1})};
    joinPulls(chain, {});
    EXPECT_EQ(chain.size(), 3U);
}

} // namespace
} // namespace join_pulls_test
} // namespace trembler::insight
