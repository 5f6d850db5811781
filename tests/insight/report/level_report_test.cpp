#include "insight/report/level_report.hpp"
#include "insight/report/report_text.hpp"
#include "tests/insight/support/on_threads.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace trembler::insight {
namespace {

ReportOptions shortReport() {
    ReportOptions options;
    options.robustness.runs = 10;
    options.drops = 10;
    options.costs = false;
    return options;
}

TEST(LevelReport, SaysWhatTheSolutionsOfTheFirstLevelNeed) {
    Workers workers(onThreads(2));
    LevelReport const report = reportOn(firstContact(), shortReport(), workers);
    EXPECT_FALSE(report.emptyToolboxSolves);
    EXPECT_EQ(report.kinds, 2U);
    nlohmann::json const json = nlohmann::json::parse(toJson(report).dump());
    EXPECT_EQ(json["level"], "levels/first/1-first-contact.json");
    EXPECT_EQ(json["empty_toolbox_solves"], false);
    ASSERT_EQ(json["solutions"].size(), 3U);
    EXPECT_EQ(json["solutions"][0]["needs_parts"], nlohmann::json::array({"steel bar"}));
    EXPECT_EQ(json["solutions"][0]["robustness"], 1.0);
    EXPECT_EQ(json["solutions"][2]["solves"], false);
    EXPECT_TRUE(json["found"].empty());
    // Each goal's chain of causes, as in `trembler why`.
    ASSERT_EQ(json["solutions"][1]["name"], "the spanner");
    ASSERT_EQ(json["solutions"][1]["chains"].size(), report.goals.size());
    for (nlohmann::json const& chain : json["solutions"][1]["chains"]) {
        EXPECT_EQ(chain["happened"], true);
        EXPECT_NE(chain["answer"].get<std::string>().find("you laid spanner 1 there"), std::string::npos)
            << chain["answer"];
    }
    // The kinds differ by their parts only.
    ASSERT_EQ(json["differences"].size(), 1U);
    EXPECT_EQ(json["differences"][0]["kind"], 2);
    EXPECT_EQ(json["differences"][0]["with"], 1);
    EXPECT_EQ(json["differences"][0]["only_here"]["parts"], nlohmann::json::array({"spanner"}));
    EXPECT_EQ(json["differences"][0]["only_there"]["parts"], nlohmann::json::array({"steel bar"}));
    std::string const page = toMarkdown({report});
    EXPECT_NE(page.find("| the steel bar | 1: steel bar; "), std::string::npos) << page;
    EXPECT_NE(toWords(report).find("'the wooden bar' does not solve it, as recorded"), std::string::npos);
    EXPECT_NE(page.find("- *the spanner*: "), std::string::npos) << page;
    EXPECT_NE(
        page.find("- Kind 2 differs from kind 1: only with kind 2: spanner; only with kind 1: steel bar."),
        std::string::npos)
        << page;
    // The same page with other threads.
    Workers one(onThreads(1));
    EXPECT_EQ(toMarkdown({reportOn(firstContact(), shortReport(), one)}), page);
}

// The goals that a demonstration reaches by itself are no solution of its task, and no shortcoming.
TEST(LevelReport, TakesTheTaskOfADemonstrationLikeAPuzzle) {
    LevelUnderTest const level(gameData(), testedFile("experiments/1-switched-electromagnet.json"));
    ReportOptions options = shortReport();
    options.robustness.runs = 4;
    options.drops = 0;
    options.chains = false;
    Workers workers(onThreads(2));
    LevelReport const report = reportOn(level, options, workers);
    EXPECT_TRUE(report.task);
    EXPECT_FALSE(report.demonstration);
    EXPECT_FALSE(report.emptyToolboxSolves);
    for (SolutionReport const& one : report.solutions) {
        EXPECT_EQ(one.expected, one.needs.solves) << one.name;
        if (one.name == "hands off") {
            EXPECT_FALSE(one.needs.solves);
        }
        if (one.name == "cut the wire") {
            EXPECT_TRUE(one.needs.solves);
            EXPECT_EQ(one.robustness.runs, 4) << "the moment of the cut was varied";
        }
    }
    EXPECT_NE(toMarkdownTable({report}).find("1-switched-electromagnet.json (task) |"), std::string::npos);
}

TEST(LevelReport, SaysThatThereIsNothingToDisplace) {
    LevelReport report;
    report.level = "a";
    report.kinds = 2;
    SolutionReport wired;
    wired.name = "a wire";
    wired.needs.solves = true;
    wired.kind = 1;
    report.solutions.push_back(wired);
    EXPECT_EQ(toMarkdownTable({report}).find("%"), std::string::npos) << "no share of no runs";
    EXPECT_TRUE(toJson(report)["solutions"][0]["robustness"].is_null());
}

TEST(LevelReport, ShowsWhatItHasAfterEachPart) {
    ReportOptions options = shortReport();
    options.maps = true;
    options.map.places = 12;
    std::vector<LevelReport> shown;
    options.sofar = [&](LevelReport const& report) { shown.push_back(report); };
    Workers workers(onThreads(2));
    LevelReport const report = reportOn(firstContact(), options, workers);
    ASSERT_EQ(shown.size(), 5U);
    EXPECT_TRUE(shown[0].examined);
    EXPECT_FALSE(shown[0].complete);
    EXPECT_EQ(shown[0].solutions.size(), 3U);
    EXPECT_EQ(shown[0].solutions[0].robustness.runs, 0);
    EXPECT_GT(shown[1].solutions[0].robustness.runs, 0);
    EXPECT_TRUE(shown[1].drops.empty());
    EXPECT_FALSE(shown[2].drops.empty());
    EXPECT_FALSE(shown[3].solutions[0].chains.empty());
    EXPECT_FALSE(shown[4].solutions[0].maps.empty());
    EXPECT_TRUE(report.complete);
    // A callback for progress changes nothing.
    options.sofar = nullptr;
    EXPECT_EQ(toJson(reportOn(firstContact(), options, workers)), toJson(report));
}

TEST(LevelReport, SaysThatNotEverythingWasExaminedIfItIsStopped) {
    Workers workers(onThreads(1, nullptr, nullptr, [] { return true; }));
    LevelReport const report = reportOn(firstContact(), shortReport(), workers);
    EXPECT_FALSE(report.examined);
    EXPECT_FALSE(report.complete);
}

TEST(LevelReport, MeasuresWhatIsNeededToComputeALevel) {
    ReportOptions options = shortReport();
    options.robustness.runs = 0;
    options.drops = 0;
    options.costs = true;
    Workers workers(onThreads(2));
    LevelReport const report = reportOn(firstContact(), options, workers);
    EXPECT_TRUE(std::any_of(report.costs.begin(), report.costs.end(), [](EffectCost const& cost) {
        return cost.effect == "dynamics" && cost.microseconds > 0;
    }));
    auto const present = std::find_if(report.ways.begin(), report.ways.end(), [](WayToCompute const& way) {
        return way.effect == "electricity" && way.present;
    });
    ASSERT_NE(present, report.ways.end());
    EXPECT_TRUE(present->keepsAll) << present->differs;
    EXPECT_TRUE(std::any_of(report.ways.begin(), report.ways.end(), [](WayToCompute const& way) {
        return way.level == "4 substeps" && way.keepsAll;
    }));
}

TEST(LevelReport, NamesTheShortcomingsOfAPuzzle) {
    LevelReport report;
    EXPECT_EQ(shortcomings(report).size(), 1U) << "no kind of solution";
    report.kinds = 2;
    EXPECT_TRUE(shortcomings(report).empty());
    report.emptyToolboxSolves = true;
    SolutionReport fragile;
    fragile.name = "a";
    fragile.needs.solves = true;
    fragile.robustness = {.runs = 10, .solved = 8};
    report.solutions.push_back(fragile);
    report.drops.push_back({"crate", 100, 6});
    EXPECT_EQ(shortcomings(report).size(), 3U);
    ASSERT_EQ(shortcomingsOf(report).size(), 3U);
    EXPECT_EQ(shortcomingsOf(report)[1].kind, Shortcoming::Kind::fragile);
    EXPECT_EQ(shortcomingsOf(report)[1].name, "a");
    EXPECT_EQ(shortcomingsOf(report)[2].kind, Shortcoming::Kind::lucky);
    EXPECT_DOUBLE_EQ(shortcomingsOf(report)[2].share, 0.06);
    report.drops.front().solved = 5;
    report.solutions.front().robustness.solved = 9;
    EXPECT_EQ(shortcomings(report).size(), 1U);
    report.demonstration = true;
    EXPECT_TRUE(shortcomings(report).empty());
}

} // namespace
} // namespace trembler::insight
