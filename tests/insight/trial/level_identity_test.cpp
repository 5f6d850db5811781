// A level's texts for people are no part of its identity; everything that its runs depend on is.
#include "insight/report/level_report.hpp"
#include "insight/report/report_text.hpp"
#include "insight/trial/level_identity.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"
#include "tests/insight/support/on_threads.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <iterator>

namespace trembler::insight {
namespace {

using ChangeOfLevel = std::function<void(LevelFile&)>;

LevelFile changedLevel(ChangeOfLevel const& change) {
    LevelFile level = loadLevel(gameData().registry, testedFile("first/1-first-contact.json"));
    change(level);
    return level;
}

/// Changes every text of a level.
void sayOtherwise(LevelFile& level) {
    level.title = "Another title";
    level.text = "Another text";
    level.hints = {"Another hint"};
    level.texts["de"] = {.title = "Ein Titel", .text = "Ein Text", .hints = {"Ein Tipp"}, .goals = {}};
    level.teaching.clear();
    level.editor = {{"notes", "to do"}};
    ASSERT_TRUE(level.goals.at("all").at(0).is_object());
    level.goals["all"][0]["text"] = "Another goal";
    for (Solution& solution : level.solutions) {
        solution.name += ", renamed";
    }
}

/// Moves the hanger by 1 mm.
void moveTheHanger(LevelFile& level) {
    for (LevelObject& object : level.objects) {
        if (object.name == "hanger") {
            Vec2 const at = object.properties.find<Position>()->value;
            object.properties.set(Position{at + Vec2{0.001, 0}});
            return;
        }
    }
    FAIL() << "there is no hanger";
}

TEST(LevelIdentity, LeavesOutWhatItTellsPeople) {
    std::string const before = identityOf(changedLevel([](LevelFile&) {}));
    EXPECT_EQ(before.size(), 16U);
    EXPECT_EQ(identityOf(changedLevel(sayOtherwise)), before);
    EXPECT_EQ(identityOf(changedLevel([](LevelFile& level) {
                  level.task = {{"text", "a"}, {"any", {{{"text", "b"}, {"on", "electromagnet"}}}}};
              })),
              identityOf(changedLevel([](LevelFile& level) {
                  level.task = {{"any", {{{"text", "c"}, {"on", "electromagnet"}}}}};
              })));
    EXPECT_EQ(identityOf(changedLevel([](LevelFile& level) { level.solutions.clear(); })), before)
        << "what is known of a level changes no run";
}

TEST(LevelIdentity, HasWhatDecidesItsRuns) {
    std::string const before = identityOf(changedLevel([](LevelFile&) {}));
    ChangeOfLevel const changes[] = {
        moveTheHanger,
        [](LevelFile& level) { level.objects.pop_back(); },
        [](LevelFile& level) { level.connections.pop_back(); },
        [](LevelFile& level) { ++level.toolbox.front().count; },
        [](LevelFile& level) { level.wires = 1; },
        [](LevelFile& level) { level.placing.reset(); },
        [](LevelFile& level) { level.goals["all"].erase(0); },
        [](LevelFile& level) { level.detail["electricity"] = "on and off"; },
    };
    for (std::size_t i = 0; i < std::size(changes); ++i) {
        EXPECT_NE(identityOf(changedLevel(changes[i])), before) << "change " << i;
    }
}

/// The numbers of a report, with displacements so large that another identity would change the counts.
nlohmann::json numbersOf(LevelFile level, Journal* journal = nullptr) {
    ReportOptions options;
    options.robustness.runs = 40;
    options.robustness.jitter = {.distance = 0.8, .angle = 90};
    options.drops = 40;
    options.costs = false;
    Workers workers(onThreads(2, nullptr, journal));
    LevelUnderTest const tested(gameData(), std::move(level), "tested");
    nlohmann::json report = nlohmann::json::parse(toJson(reportOn(tested, options, workers)).dump());
    report.erase("shortcomings"); // they name solutions
    for (nlohmann::json& solution : report["solutions"]) {
        solution.erase("name");
        for (nlohmann::json& chain : solution["chains"]) { // sentences name the goal
            chain.erase("answer");
            for (nlohmann::json& step : chain["chain"]) {
                step.erase("text");
            }
        }
    }
    return report;
}

TEST(LevelIdentity, KeepsTheNumbersOfAReportWhateverTheLevelSays) {
    nlohmann::json const before = numbersOf(changedLevel([](LevelFile&) {}));
    EXPECT_EQ(numbersOf(changedLevel(sayOtherwise)), before);
    // 1 mm changes the random numbers, and hardly the physics.
    EXPECT_NE(numbersOf(changedLevel(moveTheHanger)), before);
}

TEST(LevelIdentity, LetsAJournalTellSolutionsApart) {
    std::filesystem::path const file =
        std::filesystem::temp_directory_path() / "trembler-identity-test.jsonl";
    std::filesystem::remove(file);
    Team team;
    auto const withJournal = [&](ChangeOfLevel const& change) {
        Journal journal(file, team);
        return numbersOf(changedLevel(change), &journal);
    };
    // The level's identity stays, so the solution's own must show that its bar now lies on the floor.
    ChangeOfLevel const moved = [](LevelFile& level) { level.solutions[0].placements[0].at = {0, 0.5}; };
    EXPECT_EQ(identityOf(changedLevel(moved)), identityOf(changedLevel([](LevelFile&) {})));
    EXPECT_EQ(withJournal([](LevelFile&) {})["solutions"][0]["solves"], true);
    EXPECT_EQ(withJournal(moved), numbersOf(changedLevel(moved)));
    EXPECT_EQ(withJournal(moved)["solutions"][0]["solves"], false);
    // A change of texts causes no work to be repeated.
    auto const lines = [&] {
        Journal const journal(file, team);
        return journal.size();
    };
    std::size_t const before = lines();
    (void)withJournal([](LevelFile& level) {
        level.title = "Another title";
        level.hints = {"Another hint"};
    });
    EXPECT_EQ(lines(), before);
    std::filesystem::remove(file);
}

} // namespace
} // namespace trembler::insight
