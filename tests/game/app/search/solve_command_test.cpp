// trembler solve.
#include "tests/game/app/program.hpp"

#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <set>
#include <system_error>

namespace trembler::test {
namespace {

using nlohmann::json;

class SolveCommand : public InAFolder {
protected:
    [[nodiscard]] std::vector<std::string> solve(std::vector<std::string> const& more) const {
        std::vector<std::string> all{"solve", good, "--runs", "80", "--frames", "600"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    /// A report without the values that differ from run to run.
    static json timeless(std::string const& text) {
        json all = json::parse(text);
        for (char const* const key : {"seconds", "runs_per_second", "threads", "processes"}) {
            EXPECT_TRUE(all.contains(key)) << key;
            all.erase(key);
        }
        return all;
    }
    static std::set<std::string> keysOf(json const& object) {
        std::set<std::string> keys;
        for (auto const& [key, value] : object.items()) {
            keys.insert(key);
        }
        return keys;
    }
    /// Stops the program when the first finished run is in the journal.
    [[nodiscard]] RunAs stoppedInTheMiddle(std::string const& journal) const {
        RunAs how;
        how.meanwhile = [journal](int process) {
            waitUntil(process, [&] {
                std::error_code none;
                return std::filesystem::file_size(journal, none) > 0 && !none;
            });
            ::kill(process, SIGINT);
        };
        return how;
    }
    std::string const good = levelFile("first/1-first-contact.json").string();
};

// As many runs as fit into the time, which are the first of a search with that number of runs.
TEST_F(SolveCommand, SearchesForMinutes) {
    Ran const brief = runProgram({"solve", good, "--minutes", "0.01", "--frames", "600", "--json"});
    ASSERT_LT(brief.status, 2) << brief.err;
    json const all = json::parse(brief.out);
    EXPECT_EQ(all["complete"], false);
    json const whole = json::parse(runProgram(solve({"--json"})).out);
    EXPECT_EQ(whole["complete"], true);
    if (!all["first_solved_run"].is_null()) { // on a busy machine the time may end before
        EXPECT_EQ(all["first_solved_run"], whole["first_solved_run"]);
    }
    EXPECT_EQ(timeless(runProgram(solve({"--json", "--minutes", "1000"})).out), timeless(whole.dump()))
        << "the runs end first";
}

// Its keys are those of docs/solving.md.
TEST_F(SolveCommand, FindsSolutionsThatRun) {
    Ran const ran = runProgram(solve({"--json", "--keep", at("kept"), "--threads", "2"}));
    ASSERT_EQ(ran.status, 0) << ran.err;
    json const all = json::parse(ran.out);
    EXPECT_EQ(keysOf(all),
              (std::set<std::string>{"level", "seed", "complete", "runs", "solved_runs", "first_solved_run",
                                     "kinds", "places_of_interest", "nearest_miss", "seconds",
                                     "runs_per_second", "threads", "processes", "found"}));
    EXPECT_EQ(keysOf(all["nearest_miss"]), (std::set<std::string>{"measure", "solution"}));
    EXPECT_EQ(keysOf(all["found"].at(0)),
              (std::set<std::string>{"kind", "needs_parts", "needs_deeds", "needs_effects", "frame", "run",
                                     "times", "solution", "recorded_as", "file", "picture"}));
    EXPECT_EQ(all["runs"], 80);
    ASSERT_FALSE(all["found"].empty());
    for (json const& found : all["found"]) {
        std::string const file = found["file"];
        Ran const played = runProgram({"run", good, "--solution", file});
        EXPECT_EQ(played.status, 0) << file << "\n" << played.out << played.err;
        if (!found["picture"].is_null()) {
            EXPECT_GT(std::filesystem::file_size(found["picture"].get<std::string>()), 1000U);
        }
    }
}

TEST_F(SolveCommand, ReplacesNoFileWithWhatItKeeps) {
    std::filesystem::create_directories(at("kept"));
    std::string const level = at("kept/a.json");
    std::filesystem::copy_file(good, level);
    write(at("kept/a-found-1.png"), "mine");
    std::string const report = at("kept/a-found-1-2.json"); // written at the end, but reserved before
    Ran const ran = runProgram(
        {"solve", level, "--runs", "80", "--frames", "600", "--keep", at("kept"), "--json", report});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(contentsOf(at("kept/a-found-1.png")), "mine");
    EXPECT_EQ(contentsOf(level), contentsOf(good));
    EXPECT_NE(ran.err.find("a-found-1.png is in use"), std::string::npos) << ran.err;
    json const all = json::parse(contentsOf(report));
    ASSERT_FALSE(all["found"].empty());
    EXPECT_EQ(all["found"][0]["file"], at("kept/a-found-1-3.json"));
    EXPECT_EQ(runProgram({"run", level, "--solution", at("kept/a-found-1-3.json")}).status, 0);
    // A level with the name of a file that would be written, and two levels of one name.
    std::filesystem::create_directories(at("other"));
    std::filesystem::copy_file(good, at("other/a.json"));
    std::filesystem::copy_file(good, at("other/a-found-1.json"));
    Ran const both = runProgram({"solve", level, at("other"), "--runs", "80", "--frames", "600", "--keep",
                                 at("other"), "--json", at("both.json")});
    ASSERT_LE(both.status, 1) << both.err;
    EXPECT_EQ(contentsOf(at("other/a-found-1.json")), contentsOf(good));
    std::set<std::string> files;
    std::size_t found = 0;
    json const levels = json::parse(contentsOf(at("both.json")))["levels"];
    for (json const& one : levels) {
        for (json const& solution : one["found"]) {
            files.insert(solution["file"].get<std::string>());
            ++found;
        }
    }
    EXPECT_GE(found, 3U);
    EXPECT_EQ(files.size(), found) << "each has a file of its own";
}

TEST_F(SolveCommand, FindsTheSameAgainAndGoesOnFromAJournal) {
    Ran const one = runProgram(solve({"--json", "--threads", "1"}));
    ASSERT_EQ(one.status, 0) << one.err;
    std::vector<std::string> const journal{"--json", "--threads", "2", "--resume", at("journal.jsonl")};
    Ran const written = runProgram(solve(journal));
    EXPECT_EQ(timeless(written.out), timeless(one.out));
    auto const size = std::filesystem::file_size(at("journal.jsonl"));
    Ran const again = runProgram(solve(journal));
    EXPECT_EQ(timeless(again.out), timeless(one.out));
    EXPECT_EQ(std::filesystem::file_size(at("journal.jsonl")), size) << "nothing was left to do";
    EXPECT_EQ(runProgram(solve({"--resume", good})).status, 2) << "a level is never appended to";
}

TEST_F(SolveCommand, EndsWithWhatItHasWhenItIsInterrupted) {
    Ran const ran = runProgram(
        {"solve", good, "--runs", "100000000", "--frames", "600", "--json", "--resume", at("journal.jsonl")},
        stoppedInTheMiddle(at("journal.jsonl")));
    EXPECT_GE(ran.status, 0) << "it ended by itself";
    EXPECT_EQ(json::parse(ran.out)["complete"], false);
}

/// All levels of a table without their times.
json timelessTable(std::string const& text) {
    json all = json::parse(text);
    for (json& level : all["levels"]) {
        for (char const* const key : {"seconds", "runs_per_second", "threads", "processes"}) {
            level.erase(key);
        }
    }
    return all;
}

TEST_F(SolveCommand, ComparesManyLevelsInOneTable) {
    std::string const other = levelFile("first/3-pass-it-on.json").string();
    std::vector<std::string> const many{"solve",    good,     other,        "--runs",    "40",
                                        "--frames", "300",    "--no-hands", "--compare", "--markdown",
                                        at("t.md"), "--json", at("t.json")};
    Ran const ran = runProgram(many);
    ASSERT_LE(ran.status, 1) << ran.err;
    json const all = json::parse(contentsOf(at("t.json")));
    ASSERT_EQ(all["levels"].size(), 2U);
    EXPECT_EQ(all["complete"], true);
    std::size_t solved = 0;
    std::size_t random = 0;
    for (json const& level : all["levels"]) {
        EXPECT_EQ(level["runs"], 40);
        EXPECT_EQ(level["random"]["runs"], 40);
        EXPECT_GT(level["runs_per_second"].get<double>(), 0);
        solved += level["solved_runs"] > 0 ? 1U : 0U;
        random += level["random"]["solved_runs"] > 0 ? 1U : 0U;
    }
    EXPECT_EQ(all["solved_by_search"], solved);
    EXPECT_EQ(all["solved_at_random"], random);
    EXPECT_EQ(ran.status, solved == 2 ? 0 : 1);
    std::string const table = contentsOf(at("t.md"));
    EXPECT_NE(table.find("| level | runs | solved |"), std::string::npos) << table;
    EXPECT_NE(table.find("at random"), std::string::npos) << table;
    EXPECT_NE(ran.out.find("Solved by the search: "), std::string::npos) << ran.out;
    // A row of the table is the command's result for that level alone.
    Ran const alone =
        runProgram({"solve", good, "--runs", "40", "--frames", "300", "--no-hands", "--compare", "--json"});
    EXPECT_EQ(timeless(alone.out), timelessTable(contentsOf(at("t.json")))["levels"][0]);
}

TEST_F(SolveCommand, GoesOnWithManyLevelsFromAJournal) {
    std::filesystem::create_directories(at("pack"));
    std::filesystem::copy_file(good, at("pack/a.json"));
    std::filesystem::copy_file(levelFile("first/3-pass-it-on.json"), at("pack/b.json"));
    std::vector<std::string> const many{"solve", at("pack"),  "--runs", "40",       "--frames",
                                        "300",   "--compare", "--json", "--resume", at("j.jsonl")};
    Ran const stopped = runProgram(many, stoppedInTheMiddle(at("j.jsonl"))); // of any level, or at the end
    EXPECT_GE(stopped.status, 0) << "it ended by itself";
    Ran const gone = runProgram(many);
    ASSERT_LE(gone.status, 1) << gone.err;
    Ran const again = runProgram(many);
    EXPECT_EQ(json::parse(gone.out), json::parse(again.out)) << "the times of the first time are kept";
    std::vector<std::string> more(many.begin(), many.end() - 2);
    EXPECT_EQ(timelessTable(runProgram(more).out), timelessTable(gone.out));
}

// Everything else in the file keeps its order and its spelling, and what was added is one of its solutions.
TEST_F(SolveCommand, AddsToTheLevelWhatNobodyRecorded) {
    std::string text = contentsOf(good);
    std::size_t const solutions = text.find("  \"solutions\": [");
    ASSERT_NE(solutions, std::string::npos);
    std::string const before = text.substr(0, solutions);
    // A run of that name which does not solve it.
    std::string const mine = "{\"name\": \"found 1: steel bar\", \"expect\": \"unsolved\",  \"frames\": 100}";
    write(at("level.json"), before + "  \"solutions\": [\n    " + mine + "\n  ]\n}\n");
    std::vector<std::string> const adding{"solve", at("level.json"), "--runs", "80", "--frames",
                                          "600",   "--add-to-level", "--json"};
    Ran const ran = runProgram(adding);
    ASSERT_EQ(ran.status, 0) << ran.err;
    json const found = json::parse(ran.out)["found"];
    ASSERT_FALSE(found.empty());
    std::string const after = contentsOf(at("level.json"));
    EXPECT_TRUE(after.starts_with(before)) << after;
    EXPECT_NE(after.find(mine), std::string::npos) << after;
    json const list = json::parse(after)["solutions"];
    ASSERT_EQ(list.size(), 1 + found.size());
    std::set<std::string> names{"found 1: steel bar"};
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(list[1 + i]["name"], found[i]["added_as"]);
        EXPECT_EQ(list[1 + i]["placements"], found[i]["solution"]["placements"]);
        names.insert(found[i]["added_as"].get<std::string>());
    }
    EXPECT_EQ(names.size(), list.size()) << "each has a name of its own";
    Ran const verified = runProgram({"verify", at("level.json")});
    EXPECT_EQ(verified.status, 0) << verified.out;
    // Now they are recorded.
    Ran const again = runProgram(adding);
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_TRUE(json::parse(again.out)["found"][0]["added_as"].is_null());
    EXPECT_EQ(contentsOf(at("level.json")), after);
}

TEST_F(SolveCommand, AddsNothingToAFileThatItMustNotChange) {
    std::string const text = contentsOf(good);
    std::string newer = text;
    newer.replace(newer.find("\"version\": 2"), 12, "\"version\": 99");
    write(at("level.json"), newer);
    Ran const refused = runProgram({"solve", at("level.json"), "--runs", "80", "--add-to-level"});
    EXPECT_EQ(refused.status, 2) << refused.out;
    EXPECT_EQ(contentsOf(at("level.json")), newer);
    // Another program changes the file when the first solution has been found.
    std::string const unsolved = text.substr(0, text.find("  \"solutions\": [")) + "  \"solutions\": []\n}\n";
    std::string const changed = unsolved + "\n";
    write(at("level.json"), unsolved);
    RunAs how;
    how.meanwhile = [&](int process) {
        waitUntil(process, [&] {
            return std::filesystem::exists(at("journal.jsonl")) &&
                   contentsOf(at("journal.jsonl")).find("needs/") != std::string::npos;
        });
        write(at("level.json"), changed);
        ::kill(process, SIGINT);
    };
    Ran const late = runProgram({"solve", at("level.json"), "--runs", "100000000", "--frames", "600",
                                 "--resume", at("journal.jsonl"), "--add-to-level"},
                                how);
    EXPECT_EQ(late.status, 2) << late.out;
    EXPECT_NE(late.err.find("changed by another program"), std::string::npos) << late.err;
    EXPECT_EQ(contentsOf(at("level.json")), changed);
}

TEST_F(SolveCommand, RefusesBadInput) {
    EXPECT_EQ(runProgram({"solve", at("none.json")}).status, 2);
    EXPECT_EQ(runProgram({"solve", good, "--runs", "0"}).status, 2);
    EXPECT_EQ(runProgram({"solve", good, "--keep", "-"}).status, 2);
    Ran const report = runProgram({"report", good, "--runs", "3", "--drops", "3", "--brief", "--json"});
    EXPECT_LE(report.status, 1) << report.err;
    EXPECT_EQ(json::parse(report.out)[0]["solutions"][0]["needs_parts"], json::array({"steel bar"}));
}

} // namespace
} // namespace trembler::test
