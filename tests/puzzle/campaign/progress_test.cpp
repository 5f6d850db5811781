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
