// Progress of two programs becomes one.
#include "puzzle/campaign/progress.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>
#include <string>

namespace trembler {
namespace {

TEST(Progress, OfLevelsWhosePathsAreNotUtf8StaysApart) {
    CampaignProgress progress;
    progress.markSolved("l\xe4vel.json");
    nlohmann::ordered_json const written =
        nlohmann::ordered_json::parse(progress.written().dump()); // throws at what is not UTF-8
    CampaignProgress again;
    again.read(written);
    EXPECT_TRUE(again.of("l\xe4vel.json").solved);
    EXPECT_FALSE(again.of("l\xf6vel.json").solved);
}

TEST(Progress, NamesTheLevelsWhoseEntriesAreDamaged) {
    CampaignProgress progress;
    EXPECT_EQ(progress.read(nlohmann::ordered_json::parse(
                  R"({"a": 5, "b": {"kinds": []}, "c": "solved", "d": {"kinds": 3}, "e": {},
                      "f": {"kinds": [7, {"parts": ["x"]}]}})")),
              (std::vector<std::string>{"a", "c", "d", "f"}));
    for (char const* const solved : {"b", "d", "e", "f"}) {
        EXPECT_TRUE(progress.of(solved).solved) << solved;
    }
    EXPECT_FALSE(progress.of("a").solved);
    EXPECT_EQ(progress.of("f").kinds.size(), 1U);
}

// A newer version may have written more than this one knows.
TEST(Progress, WritesWhatItDoesNotKnowAgain) {
    auto const present = nlohmann::ordered_json::parse(
        R"({"a": 5, "new": true,
            "b": {"when": 3, "kinds": [{"parts": ["x"], "actions": [], "causes": [], "grace": 2}, "odd",
                                       {"parts": ["x"], "actions": [], "causes": [], "grace": 9}]},
            "d": {"kinds": 3}})");
    CampaignProgress progress;
    (void)progress.read(present);
    EXPECT_EQ(progress.writtenInto(present), present);
    // What is new is added.
    ASSERT_TRUE(progress.addKind("b", {{"y", "z"}, {"pull"}, {}}));
    progress.markSolved("a");
    auto const later = progress.writtenInto(present);
    EXPECT_EQ(later["b"]["when"], 3);
    ASSERT_EQ(later["b"]["kinds"].size(), 4U);
    EXPECT_EQ(later["b"]["kinds"][0]["grace"], 2);
    EXPECT_EQ(later["b"]["kinds"][1]["parts"], (nlohmann::ordered_json{"y", "z"}));
    EXPECT_EQ(later["b"]["kinds"][2], "odd");
    EXPECT_EQ(later["b"]["kinds"][3]["grace"], 9);
    EXPECT_EQ(later["a"], nlohmann::ordered_json::parse(R"({"kinds": []})"));
    EXPECT_EQ(later["new"], true);
    EXPECT_EQ(progress.writtenInto(later), later) << "once is enough";
}

TEST(Progress, NeverHasFewerStarsThanEitherPart) {
    std::mt19937 random(3);
    auto const any = [&](std::uint32_t below) { return static_cast<std::uint32_t>(random() % below); };
    auto const names = [&](std::uint32_t most) {
        std::set<std::string> all;
        for (std::uint32_t i = any(most + 1); i > 0; --i) {
            all.insert(std::string(1, static_cast<char>('a' + any(3))));
        }
        return all;
    };
    for (int round = 0; round < 2000; ++round) {
        CampaignProgress parts[2];
        for (CampaignProgress& part : parts) {
            for (std::uint32_t i = any(6); i > 0; --i) {
                std::string const level(1, static_cast<char>('x' + any(2)));
                part.addKind(level, {names(3), {}, names(1)});
                if (any(4) > 0) {
                    part.markSolved(level);
                }
            }
        }
        CampaignProgress both = parts[0];
        both.add(parts[1]);
        CampaignProgress other = parts[1];
        other.add(parts[0]);
        for (char const* level : {"x", "y", "z"}) {
            for (CampaignProgress const& part : parts) {
                EXPECT_GE(both.of(level).stars(), part.of(level).stars());
                EXPECT_GE(both.of(level).kinds.size(), part.of(level).kinds.size());
            }
            EXPECT_EQ(both.of(level).solved, other.of(level).solved);
            // All that differ are there, and no two that are alike.
            auto const& kinds = both.of(level).kinds;
            for (std::size_t i = 0; i < kinds.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    EXPECT_TRUE(differInKind(kinds[i], kinds[j]));
                }
            }
        }
        CampaignProgress again = both;
        again.add(parts[0]);
        again.add(both);
        EXPECT_EQ(again.written(), both.written()) << "once is enough";
    }
}

} // namespace
} // namespace trembler
