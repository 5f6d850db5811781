// The components that a scene activates, and why, without a world: hand-written cases.
#include "tests/runtime/world/descriptions.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

using namespace descriptions;

using Numbers = std::vector<std::size_t>;

TEST(Selection, OfNoComponentsNoneIsChosen) {
    EXPECT_TRUE(selectComponents(ComponentGraph(), {}).empty());
    EXPECT_TRUE(choicesIn({}, {.inhabited = {"o"}}).empty());
}

TEST(Selection, AComponentIsChosenWhileTheObjectsThatItNeedsExist) {
    Descriptions d;
    d.resolver({.name = "all", .needs = {"o1", "o2"}});
    d.dps({.name = "any", .needsAny = {"o2", "o3"}, .offers = {"p"}});
    d.dps({.name = "both", .needs = {"o1"}, .needsAny = {"o2", "o3"}, .offers = {"q"}});
    d.dps({.name = "always", .offers = {"r"}});
    EXPECT_EQ(chosenIn(d, {}), (Numbers{3}));
    EXPECT_EQ(chosenIn(d, {.inhabited = {"o1"}}), (Numbers{3}));
    EXPECT_EQ(chosenIn(d, {.inhabited = {"o2"}}), (Numbers{1, 3}));
    EXPECT_EQ(chosenIn(d, {.inhabited = {"o1", "o2"}}), (Numbers{0, 1, 2, 3}));
    EXPECT_EQ(chosenIn(d, {.inhabited = {"o1", "o3", "o4"}}), (Numbers{1, 2, 3}));
}

TEST(Selection, StatesWhichObjectsAreMissing) {
    Descriptions d;
    d.resolver({.name = "all", .needs = {"o1", "o2"}});
    d.dps({.name = "any", .needsAny = {"o2", "o3"}, .offers = {"p"}});
    auto const choices = choicesIn(d, {.inhabited = {"o1"}});
    EXPECT_EQ(choices[0].reason, ChoiceReason::noObjects);
    EXPECT_EQ(choices[0].property, d.property("o2"));
    EXPECT_EQ(choices[1].reason, ChoiceReason::noObjects);
    EXPECT_EQ(choices[1].property, nullptr) << "either of two properties is sufficient";
}

TEST(Selection, TheReadsOfAComponentMustBeOffered) {
    Descriptions d;
    d.interaction({.name = "glue", .reads = {"r", "p", "o1"}, .role = 1}); // listed first: no order is needed
    d.dps({.name = "derived", .reads = {"r"}, .offers = {"p"}});
    d.resolver({.name = "provider", .needs = {"o1"}, .offers = {"r"}});
    d.resolver({.name = "called", .role = 1});
    EXPECT_EQ(chosenIn(d, {.inhabited = {"o1"}}), (Numbers{0, 1, 2, 3}));
    EXPECT_EQ(chosenIn(d, {}), (Numbers{3}));
    auto const choices = choicesIn(d, {});
    EXPECT_EQ(choices[0].reason, ChoiceReason::noProvider);
    EXPECT_EQ(choices[0].property, d.property("r"));
    EXPECT_EQ(choices[1].reason, ChoiceReason::noProvider);
    EXPECT_EQ(choices[2].reason, ChoiceReason::noObjects);
}

TEST(Selection, AnInteractionNeedsAResolverOfItsRole) {
    Descriptions d;
    d.resolver({.name = "r", .needs = {"o1"}, .role = 1});
    d.interaction({.name = "of it", .role = 1});
    d.interaction({.name = "of none", .role = 2});
    EXPECT_EQ(chosenIn(d, {.inhabited = {"o1"}}), (Numbers{0, 1}));
    auto const choices = choicesIn(d, {});
    EXPECT_EQ(choices[1].reason, ChoiceReason::noResolver);
    EXPECT_EQ(choices[2].reason, ChoiceReason::noResolver);
}

TEST(Selection, OfAlternativesTheOneOfLeastRankThatSuitsIsChosen) {
    Descriptions d;
    d.dps({.name = "a", .rank = 2, .offers = {"p"}});
    d.dps({.name = "b", .rank = -1, .offers = {"p"}});
    d.dps({.name = "c", .rank = 1, .offers = {"p"}});
    d.dps({.name = "d", .rank = 1, .offers = {"p"}});
    auto choices = choicesIn(d, {});
    EXPECT_EQ(chosenIn(d, {}), (Numbers{1}));
    EXPECT_EQ(choices[1].reason, ChoiceReason::leastRank);
    EXPECT_EQ(choices[0].reason, ChoiceReason::alternativeChosen);
    EXPECT_EQ(choices[0].alternative, 1U);
    EXPECT_EQ(chosenIn(d, {.unsuitable = {1}}), (Numbers{2})) << "the first registered among equals";
    EXPECT_EQ(chosenIn(d, {.unsuitable = {1, 2}}), (Numbers{3}));
    EXPECT_EQ(chosenIn(d, {.unsuitable = {1, 2, 3}}), (Numbers{0}));
    choices = choicesIn(d, {.unsuitable = {0, 1, 2, 3}});
    EXPECT_EQ(choices[0].reason, ChoiceReason::noneSuits) << "one must be chosen: the first registered";
}

TEST(Selection, ResolversOfOneRoleAreAlternatives) {
    Descriptions d;
    d.resolver({.name = "a", .rank = 2, .role = 1});
    d.resolver({.name = "b", .rank = 1, .needs = {"o1"}, .role = 1});
    d.resolver({.name = "c", .rank = 9, .role = 2});
    EXPECT_EQ(chosenIn(d, {}), (Numbers{0, 2}));
    EXPECT_EQ(choicesIn(d, {})[0].reason, ChoiceReason::onlyCandidate);
    EXPECT_EQ(choicesIn(d, {})[1].alternative, 0U) << "for any reason, an alternative was chosen";
    EXPECT_EQ(chosenIn(d, {.inhabited = {"o1"}}), (Numbers{1, 2}));
}

TEST(Selection, ARequestedLevelTakesPrecedenceOverRankAndSuitability) {
    Descriptions d;
    d.dps({.name = "a", .level = "rough", .rank = 1, .offers = {"p"}});
    d.dps({.name = "b", .level = "fine", .rank = 2, .offers = {"p"}});
    d.dps({.name = "c", .level = "finest", .rank = 3, .needs = {"o1"}, .offers = {"p"}});
    EXPECT_EQ(chosenIn(d, {.detail = {{"effect", "fine"}}, .unsuitable = {1}}), (Numbers{1}));
    EXPECT_EQ(choicesIn(d, {.detail = {{"effect", "fine"}}})[1].reason, ChoiceReason::levelAskedFor);
    EXPECT_EQ(chosenIn(d, {.detail = {{"another", "fine"}}}), (Numbers{0}));
    EXPECT_EQ(chosenIn(d, {.detail = {{"effect", "finest"}}}), (Numbers{0})) << "it is not a candidate";
    EXPECT_EQ(chosenIn(d, {.inhabited = {"o1"}, .detail = {{"effect", "finest"}}}), (Numbers{2}));
}

TEST(Selection, SuitabilityIsQueriedOnceAndOnlyIfItDecides) {
    Descriptions d;
    d.dps({.name = "alone", .offers = {"p"}});
    d.dps({.name = "asked", .level = "fine", .rank = 5, .offers = {"q"}});
    d.dps({.name = "not asked", .level = "rough", .rank = 4, .offers = {"q"}});
    d.resolver({.name = "a", .rank = 3, .role = 1});
    d.resolver({.name = "b", .rank = 1, .role = 1});
    d.resolver({.name = "c", .rank = 2, .role = 1});
    Numbers asked;
    SelectionFacts facts{.inhabited = {}, .subscribed = {}, .detail = {{"effect", "fine"}}, .suits = {}};
    facts.suits = [&](std::size_t number) {
        asked.push_back(number);
        return number == 5;
    };
    (void)selectComponents(ComponentGraph(d.list()), facts);
    EXPECT_EQ(asked, (Numbers{4, 5}));
}

TEST(Selection, UnreadComponentsAreAbsentWithAllThatDependOnThem) {
    Descriptions d;
    d.resolver({.name = "scribe", .rank = 1, .offers = {"diary"}, .role = 1, .onDemand = true});
    d.resolver({.name = "poet", .rank = 2, .offers = {"diary"}, .role = 1, .onDemand = true});
    d.dps({.name = "fame", .reads = {"diary"}, .offers = {"fame"}, .onDemand = true});
    d.interaction({.name = "teller", .role = 1});
    d.resolver({.name = "other", .role = 2});
    d.interaction({.name = "reader", .needs = {"o1"}, .reads = {"fame"}, .role = 2});
    EXPECT_EQ(chosenIn(d, {}), (Numbers{4}));
    EXPECT_EQ(chosenIn(d, {.subscribed = {"diary"}}), (Numbers{0, 3, 4}));
    EXPECT_EQ(chosenIn(d, {.subscribed = {"fame"}}), (Numbers{0, 2, 3, 4}));
    EXPECT_EQ(chosenIn(d, {.inhabited = {"o1"}}), (Numbers{0, 2, 3, 4, 5}));
    auto const choices = choicesIn(d, {});
    EXPECT_EQ(choices[0].reason, ChoiceReason::notRead);
    EXPECT_EQ(choices[1].reason, ChoiceReason::notRead) << "its alternative is not read, so neither is it";
    EXPECT_EQ(choices[1].alternative, std::nullopt);
    EXPECT_EQ(choices[2].reason, ChoiceReason::notRead)
        << "not because the diary is missing: its own property is not read either";
    EXPECT_EQ(choices[3].reason, ChoiceReason::noResolver);
    EXPECT_EQ(choices[5].reason, ChoiceReason::noObjects);
}

TEST(Selection, AReaderThatIsNotChosenDoesNotCount) {
    Descriptions d;
    d.resolver({.name = "log", .offers = {"log"}, .role = 1, .onDemand = true});
    d.dps({.name = "cheap", .rank = 1, .offers = {"p"}});
    d.dps({.name = "thorough", .level = "fine", .rank = 2, .reads = {"log"}, .offers = {"p"}});
    EXPECT_EQ(chosenIn(d, {}), (Numbers{1}));
    EXPECT_EQ(chosenIn(d, {.detail = {{"effect", "fine"}}}), (Numbers{0, 2}));
}

// The teller reads a property of the log, which it calls: each needs the other. That does not remove them.
TEST(Selection, AnInteractionMayReadTheResolverThatItCalls) {
    Descriptions d;
    d.resolver({.name = "log", .offers = {"log"}, .role = 1, .onDemand = true});
    d.interaction({.name = "teller", .reads = {"log"}, .role = 1});
    EXPECT_EQ(chosenIn(d, {}), (Numbers{0, 1}));
}

TEST(Selection, ComponentsThatNeedEachOtherAreNoCandidates) {
    Descriptions d;
    d.dps({.name = "a", .reads = {"q"}, .offers = {"p"}});
    d.dps({.name = "b", .reads = {"p"}, .offers = {"q"}});
    d.dps({.name = "itself", .reads = {"s"}, .offers = {"s"}});
    EXPECT_EQ(chosenIn(d, {}), (Numbers{}));
    EXPECT_EQ(choicesIn(d, {})[0].reason, ChoiceReason::noProvider);
    EXPECT_EQ(choicesIn(d, {})[0].property, d.property("q"));
    d.dps({.name = "way in", .rank = 1, .needs = {"o1"}, .offers = {"q"}}); // an alternative of b
    EXPECT_EQ(chosenIn(d, {}), (Numbers{}));
    EXPECT_EQ(chosenIn(d, {.inhabited = {"o1"}}), (Numbers{0, 1})) << "another component now provides it";
}

} // namespace
} // namespace trembler
