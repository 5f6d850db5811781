// trembler solve, report and verify, shared out among processes by mpirun.
#include "tests/game/app/program.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <vector>

namespace trembler::test {
namespace {

using nlohmann::json;

class SharedOut : public InAFolder {
protected:
    void SetUp() override {
        InAFolder::SetUp();
        if (!std::filesystem::exists(TREMBLER_BINARY_DIR "/trembler-mpi.so") ||
            std::system("command -v mpirun >/dev/null 2>&1") != 0) { // NOLINT(*-mt-unsafe): one thread
            GTEST_SKIP() << "built without MPI, or there is no mpirun: scripts/install clusters";
        }
    }
    /// The file that the program writes when this number of processes runs it.
    [[nodiscard]] std::string shared(int processes, std::string const& arguments) const {
        std::string const file = at(fmt::format("out-{}.json", processes));
        // The variables let Open MPI be run by root, as in a container.
        std::string const command = fmt::format(
            "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe -n {} "
            "'" TREMBLER_BINARY_DIR "/trembler' {} {} --mpi --json '{}' >'{}' 2>&1",
            processes, arguments, arguments.starts_with("verify") ? "" : "--threads 1", file, at("words"));
        int const status = std::system(command.c_str()); // NOLINT(*-mt-unsafe)
        EXPECT_TRUE(WIFEXITED(status)) << contentsOf(at("words"));
        EXPECT_LE(WEXITSTATUS(status), 1) << contentsOf(at("words"));
        return contentsOf(file);
    }
    std::string const good = levelFile("first/1-first-contact.json").string();
    /// Three levels, with the options of a search.
    std::string const several = fmt::format("solve '{}' '{}' '{}' --runs 70 --frames 600 --no-hands", good,
                                            levelFile("first/2-into-the-basket.json").string(),
                                            levelFile("2-electricity/1-both-gaps.json").string());
};

/// The results of a search of several levels, without values that depend on time and on the processes.
json foundIn(std::string const& text) {
    json all = json::parse(text);
    for (json& level : all["levels"]) {
        for (char const* const key : {"seconds", "runs_per_second", "processes"}) {
            level.erase(key);
        }
    }
    return all;
}

/// Leaves the first half of a file, and half a line more, as a power cut does. Returns the whole lines that
/// remain.
std::string cutInTheMiddle(std::filesystem::path const& file) {
    std::string const text = contentsOf(file);
    EXPECT_GT(text.size(), 1000U) << file;
    std::size_t const cut = std::min(text.find('\n', text.size() / 2) + 20, text.size() - 1);
    std::filesystem::resize_file(file, cut);
    return text.substr(0, text.substr(0, cut).rfind('\n') + 1);
}

/// The work that the whole lines of a journal report as finished.
std::vector<std::string> finishedWork(std::filesystem::path const& file) {
    std::vector<std::string> works;
    std::istringstream lines(contentsOf(file));
    for (std::string line; std::getline(lines, line);) {
        json const entry = json::parse(line, nullptr, false);
        if (entry.is_object()) {
            works.push_back(entry.at("work"));
        }
    }
    return works;
}

TEST_F(SharedOut, ASearchFindsTheSameInAnyNumberOfProcesses) {
    json expected;
    for (int const processes : {1, 2, 3}) {
        json all = json::parse(shared(processes, fmt::format("solve '{}' --runs 90 --frames 600", good)));
        EXPECT_EQ(all["processes"], processes);
        for (char const* const key : {"seconds", "runs_per_second", "processes"}) {
            all.erase(key);
        }
        EXPECT_FALSE(all["found"].empty());
        if (processes == 1) {
            expected = all;
        }
        EXPECT_EQ(all, expected) << processes;
    }
}

TEST_F(SharedOut, SeveralLevelsAreSearchedTheSameByAnyNumberOfProcesses) {
    json const one = foundIn(shared(1, several));
    ASSERT_EQ(one["levels"].size(), 3U);
    EXPECT_EQ(one["complete"], true);
    EXPECT_GE(one["solved_by_search"], 1);
    for (int const processes : {2, 3}) {
        EXPECT_EQ(foundIn(shared(processes, several)), one) << processes;
    }
}

TEST_F(SharedOut, ASearchOfSeveralLevelsThatWasCutOffGoesOn) {
    std::string const arguments = several + fmt::format(" --resume '{}'", at("pack.jsonl"));
    json const whole = foundIn(shared(2, arguments));
    std::string const first = cutInTheMiddle(at("pack.jsonl"));
    std::string const second = cutInTheMiddle(at("pack.jsonl.1"));
    EXPECT_EQ(foundIn(shared(2, arguments)), whole);
    // The finished work is still there, and nothing was computed twice.
    EXPECT_EQ(contentsOf(at("pack.jsonl")).substr(0, first.size()), first);
    EXPECT_EQ(contentsOf(at("pack.jsonl.1")).substr(0, second.size()), second);
    std::vector<std::string> works = finishedWork(at("pack.jsonl"));
    std::vector<std::string> const others = finishedWork(at("pack.jsonl.1"));
    works.insert(works.end(), others.begin(), others.end());
    EXPECT_GT(works.size(), 2U);
    std::sort(works.begin(), works.end());
    EXPECT_EQ(std::adjacent_find(works.begin(), works.end()), works.end());
}

TEST_F(SharedOut, AReportIsTheSameInAnyNumberOfProcesses) {
    std::string const arguments = fmt::format("report '{}' --runs 8 --drops 4 --brief", good);
    std::string const expected = shared(1, arguments);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(shared(2, arguments), expected);
    EXPECT_EQ(shared(3, arguments), expected);
}

TEST_F(SharedOut, AReportThatWasCutOffGoesOn) {
    std::string const arguments =
        fmt::format("report '{}' --runs 8 --drops 4 --brief --resume '{}'", good, at("report.jsonl"));
    std::string const whole = shared(2, arguments);
    std::string const first = cutInTheMiddle(at("report.jsonl"));
    std::string const second = cutInTheMiddle(at("report.jsonl.1"));
    EXPECT_EQ(shared(3, arguments), whole) << "by another number of processes";
    EXPECT_EQ(contentsOf(at("report.jsonl")).substr(0, first.size()), first);
    EXPECT_EQ(contentsOf(at("report.jsonl.1")).substr(0, second.size()), second);
    std::vector<std::string> works = finishedWork(at("report.jsonl"));
    for (char const* const other : {"report.jsonl.1", "report.jsonl.2"}) {
        std::vector<std::string> const more = finishedWork(at(other));
        works.insert(works.end(), more.begin(), more.end());
    }
    std::sort(works.begin(), works.end());
    EXPECT_EQ(std::adjacent_find(works.begin(), works.end()), works.end()) << "nothing was computed twice";
}

TEST_F(SharedOut, AVerdictIsTheSameInAnyNumberOfProcesses) {
    // One level that is valid, and one whose solution does not solve it.
    json broken = json::parse(contentsOf(good));
    broken["solutions"][2]["expect"] = "solved"; // the wooden bar
    std::ofstream(at("broken.json")) << broken;
    std::string const arguments = fmt::format("verify '{}' '{}' '{}'", good, at("broken.json"),
                                              levelFile("first/2-into-the-basket.json").string());
    std::string const one = shared(1, arguments);
    json const verdict = json::parse(one);
    ASSERT_EQ(verdict["levels"].size(), 3U);
    EXPECT_EQ(verdict["levels"][0]["valid"].get<bool>() + verdict["levels"][1]["valid"].get<bool>() +
                  verdict["levels"][2]["valid"].get<bool>(),
              2);
    EXPECT_EQ(shared(2, arguments), one);
    EXPECT_EQ(shared(3, arguments), one);
}

TEST_F(SharedOut, AVerificationThatWasCutOffGoesOn) {
    std::string const arguments = fmt::format("verify '{}' '{}' '{}' --resume '{}'", good,
                                              levelFile("first/2-into-the-basket.json").string(),
                                              levelFile("first/3-pass-it-on.json").string(), at("all.jsonl"));
    std::string const whole = shared(2, arguments);
    std::vector<std::string> works = finishedWork(at("all.jsonl"));
    EXPECT_EQ(works.size(), 2U);
    EXPECT_EQ(finishedWork(at("all.jsonl.1")).size(), 1U);
    // The last line of the leader is lost, as by a power cut.
    std::string const text = contentsOf(at("all.jsonl"));
    std::filesystem::resize_file(at("all.jsonl"), text.size() - 5);
    EXPECT_EQ(shared(1, arguments), whole) << "by another number of processes";
    works = finishedWork(at("all.jsonl"));
    EXPECT_EQ(works.size(), 2U) << "only the lost one was verified again";
    EXPECT_EQ(shared(3, arguments), whole);
    EXPECT_EQ(finishedWork(at("all.jsonl")), works) << "nothing was left to do";
}

TEST_F(SharedOut, FinishedWorkIsNotDoneAgain) {
    std::string const arguments =
        fmt::format("solve '{}' --runs 70 --frames 600 --resume '{}'", good, at("journal.jsonl"));
    json two = json::parse(shared(2, arguments));
    std::string const first = contentsOf(at("journal.jsonl"));
    std::string const second = contentsOf(at("journal.jsonl.1"));
    EXPECT_FALSE(second.empty()) << "each process writes a file of its own";
    json three = json::parse(shared(3, arguments));
    EXPECT_EQ(two["found"], three["found"]);
    EXPECT_EQ(contentsOf(at("journal.jsonl")), first);
    EXPECT_EQ(contentsOf(at("journal.jsonl.1")), second);
}

} // namespace
} // namespace trembler::test
