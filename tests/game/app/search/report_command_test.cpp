// trembler report.
#include "tests/game/app/program.hpp"

#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <set>
#include <system_error>

namespace trembler::test {
namespace {

using nlohmann::json;

class ReportCommand : public InAFolder {
protected:
    /// A report on two levels, without the parts that take long or differ from run to run.
    [[nodiscard]] std::vector<std::string> report(std::vector<std::string> const& more) const {
        std::vector<std::string> all{"report", first,     second,     "--runs", "8",     "--drops",
                                     "8",      "--brief", "--search", "70",     "--json"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    static std::set<std::string> keysOf(json const& object) {
        std::set<std::string> keys;
        for (auto const& [key, value] : object.items()) {
            keys.insert(key);
        }
        return keys;
    }
    std::string const first = levelFile("first/1-first-contact.json").string();
    std::string const second = levelFile("first/2-into-the-basket.json").string();
};

TEST_F(ReportCommand, EndsWithWhatItHasWhenItIsInterrupted) {
    // More runs than could be finished before the signal, however busy the machine is.
    std::vector<std::string> const endless{
        "report",  first,    second,     "--runs",    "8",        "--drops",          "8",
        "--brief", "--json", "--search", "100000000", "--resume", at("journal.jsonl")};
    Ran const stopped =
        runProgram(endless, {.meanwhile = [&](int process) {
                       waitUntil(process, [&] {
                           std::error_code none;
                           return std::filesystem::file_size(at("journal.jsonl"), none) > 0 && !none;
                       });
                       ::kill(process, SIGINT);
                   }});
    EXPECT_EQ(stopped.status, 1) << stopped.err;
    EXPECT_NE(stopped.err.find("goes on from there"), std::string::npos) << stopped.err;
    json const part = json::parse(stopped.out);
    ASSERT_FALSE(part.empty());
    EXPECT_EQ(part.back()["complete"], false);
}

TEST_F(ReportCommand, GoesOnWithSeveralLevelsWhereItWasStopped) {
    Ran const whole = runProgram(report({"--threads", "2"}));
    ASSERT_LE(whole.status, 1) << whole.err;
    ASSERT_EQ(json::parse(whole.out).size(), 2U);
    std::vector<std::string> const journal = report({"--threads", "1", "--resume", at("journal.jsonl")});
    Ran const before = runProgram(journal);
    ASSERT_LE(before.status, 1) << before.err;
    // After a stop the journal holds a beginning of the work; its last line may be incomplete.
    std::string const lines = contentsOf(at("journal.jsonl"));
    std::size_t const half = lines.find('\n', lines.size() / 2);
    ASSERT_NE(half, std::string::npos);
    write(at("journal.jsonl"), lines.substr(0, half + 20));
    Ran const rest = runProgram(journal);
    EXPECT_EQ(json::parse(rest.out), json::parse(whole.out));
    auto const size = std::filesystem::file_size(at("journal.jsonl"));
    Ran const again = runProgram(journal);
    EXPECT_EQ(json::parse(again.out), json::parse(whole.out));
    EXPECT_EQ(std::filesystem::file_size(at("journal.jsonl")), size) << "nothing was left to do";
}

// docs/solving.md lists them: keys are added, never renamed.
TEST_F(ReportCommand, WritesTheKeysThatAreDocumented) {
    Ran const ran =
        runProgram({"report", first, "--runs", "2", "--drops", "2", "--maps", "--search", "70", "--json"});
    ASSERT_LE(ran.status, 1) << ran.err;
    json const all = json::parse(ran.out);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(keysOf(all[0]),
              (std::set<std::string>{"level", "complete", "demonstration", "task", "empty_toolbox_solves",
                                     "seed", "jitter", "kinds", "solutions", "drops", "effects",
                                     "ways_to_compute", "found", "search", "shortcomings", "differences"}));
    EXPECT_EQ(keysOf(all[0]["jitter"]), (std::set<std::string>{"cm", "degrees", "seconds"}));
    EXPECT_EQ(keysOf(all[0]["solutions"][0]),
              (std::set<std::string>{"name", "expected_to_solve", "solves", "frame", "kind", "kind_number",
                                     "needs_parts", "needs_deeds", "needs_effects", "superfluous",
                                     "reduced_frame", "superfluous_effects", "robustness", "robustness_runs",
                                     "robustness_redrawn", "places", "chains"}));
    EXPECT_EQ(
        keysOf(all[0]["solutions"][0]["chains"][0]),
        (std::set<std::string>{"asked", "happened", "answer", "confirmed", "chain", "dropped", "runs"}));
    EXPECT_EQ(keysOf(all[0]["solutions"][0]["places"][0]),
              (std::set<std::string>{"part", "placement", "step_m", "recorded", "runs", "rows"}));
    EXPECT_EQ(keysOf(all[0]["drops"][0]), (std::set<std::string>{"part", "runs", "solved", "share"}));
    EXPECT_EQ(keysOf(all[0]["effects"][0]), (std::set<std::string>{"effect", "us_per_frame"}));
    EXPECT_EQ(keysOf(all[0]["ways_to_compute"][0]),
              (std::set<std::string>{"effect", "level", "present", "keeps_all_verdicts", "differs_in",
                                     "us_per_frame"}));
    EXPECT_EQ(keysOf(all[0]["search"]), (std::set<std::string>{"runs", "solved"}));
    ASSERT_FALSE(all[0]["found"].empty());
    EXPECT_EQ(keysOf(all[0]["found"][0]),
              (std::set<std::string>{"kind", "needs_parts", "needs_deeds", "needs_effects", "frame", "run",
                                     "times", "solution", "recorded_as"}));
}

} // namespace
} // namespace trembler::test
