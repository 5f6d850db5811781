// The differences between kinds of solutions, and the stars for them.
#include "puzzle/campaign/progress.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/level/read/read_level.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace trembler {
namespace {

SolutionKind with(std::set<std::string> parts) {
    return {std::move(parts), {}, {"Electricity Resolver"}};
}

TEST(SolutionKind, IsThatOfTheRun) {
    GameData const data;
    LevelFile const level = loadLevel(data.registry, std::filesystem::path(TREMBLER_SOURCE_DIR) /
                                                         "levels/first/1-first-contact.json");
    auto const kindOfNamed = [&](char const* name) {
        return kindOf(data.registry, data.parts, level, *level.findSolution(name), 600);
    };
    KindOfRun const bar = kindOfNamed("the steel bar");
    EXPECT_TRUE(bar.solves);
    EXPECT_EQ(bar.kind.parts, std::set<std::string>{"steel bar"});
    EXPECT_TRUE(bar.kind.actions.empty());
    EXPECT_TRUE(bar.kind.causes.contains("Electricity <- Dynamics"))
        << "the contacts of the bar close the circuit";
    EXPECT_EQ(kindOfNamed("the steel bar").kind, bar.kind) << "a pure function";
    KindOfRun const spanner = kindOfNamed("the spanner");
    EXPECT_TRUE(spanner.solves);
    EXPECT_TRUE(differInKind(bar.kind, spanner.kind));
    EXPECT_FALSE(kindOfNamed("the wooden bar").solves);
    // The same parts in another place are the same kind.
    Solution moved = *level.findSolution("the steel bar");
    moved.placements.front().at.x += 0.02;
    EXPECT_FALSE(differInKind(bar.kind, kindOf(data.registry, data.parts, level, moved, 600).kind));
}

TEST(SolutionKind, APartThatIsMerelyAddedIsNoOtherKind) {
    EXPECT_FALSE(differInKind(with({"a"}), with({"a"})));
    EXPECT_FALSE(differInKind(with({"a"}), with({"a", "b"})));
    EXPECT_FALSE(differInKind(with({"a", "b"}), with({"a"})));
    EXPECT_TRUE(differInKind(with({"a", "b"}), with({"a", "c"})));
    EXPECT_TRUE(differInKind(with({"a"}), with({"b"})));
    SolutionKind byHand = with({"a"});
    byHand.actions = {"grab"};
    EXPECT_TRUE(differInKind(with({"a"}), byHand));
    SolutionKind otherCause = with({"a"});
    otherCause.causes.insert("Magnetism Resolver");
    EXPECT_TRUE(differInKind(with({"a"}), otherCause));
}

TEST(CampaignProgress, HasAStarForSolvingAndOneForEachOtherKind) {
    CampaignProgress progress;
    EXPECT_EQ(progress.of("x").stars(), 0);
    EXPECT_TRUE(progress.markSolved("x"));
    EXPECT_FALSE(progress.markSolved("x"));
    EXPECT_EQ(progress.of("x").stars(), 1);
    EXPECT_TRUE(progress.addKind("x", with({"a"})));
    EXPECT_EQ(progress.of("x").stars(), 1);
    EXPECT_FALSE(progress.addKind("x", with({"a", "b"})));
    EXPECT_TRUE(progress.addKind("x", with({"b"})));
    EXPECT_EQ(progress.of("x").stars(), 2);
    EXPECT_TRUE(progress.addKind("x", with({"c"})));
    EXPECT_TRUE(progress.addKind("x", with({"d"})));
    EXPECT_EQ(progress.of("x").stars(), mostStars);
    CampaignProgress again;
    again.read(progress.written());
    EXPECT_EQ(again.of("x").kinds, progress.of("x").kinds);
    EXPECT_TRUE(again.of("x").solved);
    again.clear();
    again.read(nlohmann::ordered_json::parse(
        R"({"y": {"kinds": [7, {"parts": "b", "causes": [1, "c"]}]}, "z": [], "w": {}})"));
    EXPECT_TRUE(again.of("y").solved);
    EXPECT_EQ(again.of("y").kinds.size(), 1U);
    EXPECT_FALSE(again.of("z").solved);
    EXPECT_TRUE(again.of("w").solved);
}

} // namespace
} // namespace trembler
