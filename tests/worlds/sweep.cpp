// sweep_worlds: tests random levels from the schema for a given time, on every engine and several numbers of
// threads. Prints a line for each level that fails and saves it as a file; exit status 1 if any failed.
//
//   sweep_worlds --minutes 60 --jobs 8 --seed 1 --keep failing
#include "puzzle/goals/level_schema.hpp"
#include "tests/levels/level_kit.hpp"
#include "tests/worlds/random_level.hpp"
#include "tests/worlds/trial.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

using namespace trembler;
using namespace trembler::worlds;
using Clock = std::chrono::steady_clock;

struct Arguments {
    double minutes = 1;
    std::uint64_t seed = 1;
    std::uint64_t worlds = 0;
    unsigned jobs = 1;
    std::string keep = "failing-levels";
    TrialOptions trial;
};

/// The progress of all jobs, in shared memory.
struct Tally {
    std::atomic<std::uint64_t> tried;
    std::atomic<std::uint64_t> played;
    std::atomic<std::uint64_t> failed;
};

void keep(Arguments const& arguments, std::string const& name, Outcome const& outcome,
          std::string const& words) {
    std::filesystem::create_directories(arguments.keep);
    std::ofstream(std::filesystem::path(arguments.keep) / (name + ".json")) << outcome.level.dump(1) << "\n";
    std::ofstream(std::filesystem::path(arguments.keep) / (name + ".txt")) << words << "\n";
}

void work(Arguments const& arguments, unsigned job, Clock::time_point end, Tally& tally) {
    nlohmann::json const schema = levelSchema(levelKit().registry);
    RandomLevels const levels(schema, levelKit().parts.names());
    for (std::uint64_t i = job; arguments.worlds == 0 ? Clock::now() < end : i < arguments.worlds;
         i += arguments.jobs) {
        std::uint64_t const seed = arguments.seed + i;
        Outcome const outcome = tryOut(levels.make(seed), schema, arguments.trial);
        ++tally.tried;
        tally.played += outcome.played ? 1U : 0U;
        std::string words;
        for (Failure const& failure : outcome.failures) {
            words += fmt::format("seed {}: {}\n", seed, inWords(failure));
        }
        if (!words.empty()) {
            ++tally.failed;
            keep(arguments, fmt::format("seed-{}", seed), outcome, words);
        }
        std::fputs(words.c_str(), stdout);
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App program("Random levels from the schema, on every engine and several numbers of threads.");
    program.add_option("--minutes", arguments.minutes, "How long")->check(CLI::Range(0.01, 1e5));
    program.add_option("--worlds", arguments.worlds, "How many, instead of how long");
    program.add_option("--seed", arguments.seed, "Of the first level; the next has the next");
    program.add_option("--jobs", arguments.jobs, "Levels at the same time")->check(CLI::Range(1, 256));
    program.add_option("--frames", arguments.trial.frames, "Of every run")->check(CLI::Range(1, 100000));
    program.add_option("--engines", arguments.trial.engines, "Of native, box2d, chipmunk and ode")
        ->delimiter(',');
    program.add_option("--threads", arguments.trial.threads, "Numbers of threads, for example 1,2,5")
        ->delimiter(',');
    program
        .add_option("--slow-frame", arguments.trial.frameSeconds,
                    "Seconds of processor time that a frame may take")
        ->capture_default_str();
    program.add_option("--keep", arguments.keep, "Folder for the levels that fail");
    CLI11_PARSE(program, argc, argv);

    void* const shared =
        mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) {
        std::perror("sweep_worlds");
        return 2;
    }
    auto& tally = *new (shared) Tally{};
    (void)levelKit(); // once, before the jobs begin
    auto const end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(60 * arguments.minutes));
    for (unsigned job = 0; job < arguments.jobs; ++job) {
        if (fork() == 0) {
            work(arguments, job, end, tally);
            _exit(0);
        }
    }
    auto const progress = [&] {
        return fmt::format("{} levels, {} played, {} failed", tally.tried.load(), tally.played.load(),
                           tally.failed.load());
    };
    for (unsigned left = arguments.jobs; left > 0;) {
        pid_t const done = waitpid(-1, nullptr, WNOHANG);
        left -= done > 0 ? 1U : 0U;
        if (isatty(STDERR_FILENO) != 0) {
            std::fputs(("\r" + progress()).c_str(), stderr);
        }
        if (done <= 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
        }
    }
    std::printf("\n%s\n", progress().c_str());
    return tally.failed > 0 ? 1 : 0;
}
