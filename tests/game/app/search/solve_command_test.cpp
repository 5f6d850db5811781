// trembler solve.
#include "tests/game/app/program.hpp"

#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <system_error>
#include <unistd.h>

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
    /// A report without what differs from run to run.
    static json timeless(std::string const& text) {
        json all = json::parse(text);
        for (char const* const key : {"seconds", "runs_per_second", "threads", "processes"}) {
            EXPECT_TRUE(all.contains(key)) << key;
            all.erase(key);
        }
        return all;
    }
    std::string const good = levelFile("first/1-first-contact.json").string();
};

TEST_F(SolveCommand, FindsSolutionsThatRun) {
    Ran const ran = runProgram(solve({"--json", "--keep", at("kept"), "--threads", "2"}));
    ASSERT_EQ(ran.status, 0) << ran.err;
    json const all = json::parse(ran.out);
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
    RunAs how;
    how.meanwhile = [this](int process) {
        std::error_code error;
        while (!std::filesystem::exists(at("journal.jsonl"), error) ||
               std::filesystem::file_size(at("journal.jsonl"), error) == 0) {
            ::usleep(10'000);
        }
        ::kill(process, SIGINT);
    };
    Ran const ran = runProgram(
        {"solve", good, "--runs", "100000000", "--frames", "600", "--json", "--resume", at("journal.jsonl")},
        how);
    EXPECT_GE(ran.status, 0) << "it ended by itself";
    EXPECT_EQ(json::parse(ran.out)["complete"], false);
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
