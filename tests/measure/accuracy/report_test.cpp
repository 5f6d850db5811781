// Reports contain the measured figures.
#include "measure/accuracy/report.hpp"
#include "tests/measure/accuracy/three_rungs.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace trembler::accuracy {
namespace {

TEST(AccuracyReport, JsonHasEveryRung) {
    std::vector<Ladder> all{threeRungs()};
    markFront(all[0]);
    auto const json = nlohmann::json::parse(asJson(all).dump());
    auto const& levels = json.at("ladders").at(0).at("levels");
    ASSERT_EQ(levels.size(), 5U);
    EXPECT_EQ(levels[1].at("beaten_by"), "cheap");
    EXPECT_EQ(levels[1].at("error"), 0.6);
    EXPECT_EQ(levels[1].at("us_per_frame"), 10);
    EXPECT_EQ(levels[1].at("cannot_tell"), "much | more");
    EXPECT_TRUE(levels[4].at("error").is_null());
    EXPECT_EQ(levels[0].at("front"), true);
}

TEST(AccuracyReport, MarkdownIsATableAndTextNamesBeatenLevels) {
    std::vector<Ladder> all{threeRungs()};
    markFront(all[0]);
    std::string const markdown = asMarkdown(all, "pictures");
    EXPECT_NE(markdown.find("| silly | 10 | 0.6 | beaten by cheap | much \\| more |\n"), std::string::npos)
        << markdown;
    EXPECT_NE(markdown.find("| torn | 5 | no bound | beaten by cheap | all |\n"), std::string::npos);
    EXPECT_NE(markdown.find("(pictures/accuracy-gravity-a-made-up-scene-more.svg)"), std::string::npos);
    std::string const text = asText(all);
    EXPECT_NE(text.find("beaten by cheap"), std::string::npos);
    EXPECT_NE(text.find("expensive cannot represent little"), std::string::npos);
}

TEST(AccuracyReport, WhatNoLevelCanRepresentIsStatedOnce) {
    std::vector<Ladder> all{threeRungs()};
    for (Rung& rung : all[0].rungs) {
        rung.cannotRepresent = "the future";
    }
    markFront(all[0]);
    std::string const markdown = asMarkdown(all, "");
    EXPECT_NE(markdown.find("None of them can represent the future.\n"), std::string::npos) << markdown;
    EXPECT_NE(markdown.find("| silly | 10 | 0.6 | beaten by cheap |\n"), std::string::npos);
    EXPECT_EQ(markdown.find("the future"), markdown.rfind("the future"));
    EXPECT_EQ(markdown.find("what it cannot represent"), std::string::npos);
}

} // namespace
} // namespace trembler::accuracy
