// sweep_input: random input to the whole program for a given time, offscreen: game, menus, free play, editor.
// Prints a line for each scene that fails and keeps its list of events; exit status 1 if any failed, or if
// memory grows.
//
//   sweep_input --minutes 60 --seed 1 --keep failing-input
//   sweep_input --seed 17 --scenes 1 --tell    # the scene with that seed again, with all its events
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/random/random_player.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

using namespace trembler;
using namespace trembler::ui::test;
using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

struct Arguments {
    double minutes = 1;
    std::uint64_t seed = 1;
    std::uint64_t scenes = 0;
    int acts = 400;
    fs::path keep = "failing-input";
    double growth = 1.3;
    bool tell = false;
};

/// Shared by the process that plays and the one that watches it.
struct Tally {
    std::atomic<std::uint64_t> scene; ///< the seed of the one that is played
    std::atomic<std::uint64_t> scenes;
    std::atomic<std::uint64_t> acts;
    std::atomic<std::uint64_t> pictures;
    std::atomic<std::uint64_t> failed;
    std::atomic<std::uint64_t> grown;
    std::atomic<std::uint64_t> seen; ///< cards and buttons with different names
};

double residentMegabytes() {
    std::ifstream file("/proc/self/statm");
    double total = 0;
    double resident = 0;
    file >> total >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

double median(std::vector<double> all) {
    auto const middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return all.empty() ? 0 : *middle;
}

/// Memory after each scene, when the program has ended: the rest is kept on purpose, or leaks.
class Growth {
public:
    void look() {
        malloc_trim(0);
        heap_.push_back(static_cast<double>(mallinfo2().uordblks) / 1e6);
        resident_.push_back(residentMegabytes());
    }
    /// Whether the last quarter is larger than the second by this factor.
    [[nodiscard]] bool tell(double most) const {
        if (heap_.size() < 16) {
            return false;
        }
        bool grown = false;
        for (auto const& [name, all] : {std::pair("heap", &heap_), std::pair("resident", &resident_)}) {
            auto const quarter = static_cast<std::ptrdiff_t>(all->size() / 4);
            double const early = median({all->begin() + quarter, all->begin() + 2 * quarter});
            double const late = median({all->end() - quarter, all->end()});
            std::printf("%s: %.1f MB after warming up, %.1f MB at the end\n", name, early, late);
            grown = grown || late > most * early;
        }
        return grown;
    }

private:
    std::vector<double> heap_;
    std::vector<double> resident_;
};

/// Plays one scene; throws the program's exceptions, or std::logic_error.
void play(Arguments const& arguments, std::uint64_t seed, fs::path const& folder, Tally& tally,
          std::set<std::string>& seen) {
    // Written line by line, so that it is complete however the scene ends.
    std::ofstream log(folder / "acts.txt");
    RandomPlayer player(window(), gameData(), folder / "player", seed);
    for (int i = 0; i < arguments.acts; ++i) {
        std::string const act = player.act();
        log << act << std::endl;
        if (arguments.tell) {
            std::puts(act.c_str());
        }
        ++tally.acts;
    }
    log << "end" << std::endl;
    tally.pictures += player.pictures();
    seen.insert(player.seen().begin(), player.seen().end());
    tally.seen = seen.size();
    player.end();
    std::string faults;
    for (std::string const& fault : player.faultsOfFiles()) {
        faults += fault + "\n";
    }
    if (!faults.empty()) {
        throw std::logic_error(faults);
    }
}

void keep(Arguments const& arguments, std::uint64_t seed, fs::path const& folder, std::string const& why) {
    std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed), why.c_str());
    std::fflush(stdout);
    fs::path const kept = arguments.keep / fmt::format("seed-{}", seed);
    std::error_code ignored;
    fs::remove_all(kept, ignored);
    fs::create_directories(arguments.keep, ignored);
    fs::copy(folder, kept, fs::copy_options::recursive, ignored);
    std::ofstream(kept / "why.txt") << why << "\n";
}

/// Plays until the time is over; the watching process begins again if it dies.
int work(Arguments const& arguments, std::uint64_t first, fs::path const& folder, Clock::time_point end,
         Tally& tally) {
    std::set<std::string> seen;
    Growth growth;
    for (std::uint64_t seed = first;
         arguments.scenes == 0 ? Clock::now() < end : seed < arguments.seed + arguments.scenes; ++seed) {
        tally.scene = seed;
        try {
            play(arguments, seed, folder, tally, seen);
        } catch (std::exception const& error) {
            ++tally.failed;
            keep(arguments, seed, folder, error.what());
        }
        ++tally.scenes;
        growth.look();
    }
    closeWindow();
    tally.grown += growth.tell(arguments.growth) ? 1U : 0U;
    return 0;
}

/// Waits for the playing process; returns how it ended, "" if in order.
std::string watch(pid_t player, Tally const& tally) {
    constexpr int patience = 180; // s without an act, on a busy machine
    std::uint64_t acts = 0;
    auto changed = Clock::now();
    for (;;) {
        int status = 0;
        if (waitpid(player, &status, WNOHANG) == player) {
            if (WIFSIGNALED(status)) {
                return fmt::format("ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
            }
            return WEXITSTATUS(status) == 0 ? "" : fmt::format("ended with {}", WEXITSTATUS(status));
        }
        if (tally.acts != acts) {
            acts = tally.acts;
            changed = Clock::now();
        } else if (Clock::now() - changed > std::chrono::seconds(patience)) {
            kill(player, SIGKILL);
            waitpid(player, &status, 0);
            return fmt::format("nothing happened for {} s", patience);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App program("Random input to the whole program, offscreen.");
    program.add_option("--minutes", arguments.minutes, "How long")->check(CLI::Range(0.01, 1e5));
    program.add_option("--scenes", arguments.scenes, "How many scenes, instead of how long");
    program.add_option("--acts", arguments.acts, "Of every scene")->check(CLI::Range(1, 1000000));
    program.add_option("--seed", arguments.seed, "Of the first scene; the next has the next");
    program.add_option("--keep", arguments.keep, "Folder for the scenes that fail");
    program.add_option("--growth", arguments.growth, "Factor by which memory may grow after warming up");
    program.add_flag("--tell", arguments.tell, "Print everything that is done");
    CLI11_PARSE(program, argc, argv);
    arguments.keep = fs::absolute(arguments.keep);

    void* const shared =
        mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) {
        std::perror("sweep_input");
        return 2;
    }
    auto& tally = *new (shared) Tally{};
    fs::path const folder = fs::temp_directory_path() / fmt::format("sweep-input-{}", getpid());
    fs::create_directories(folder);
    auto const end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(60 * arguments.minutes));
    std::uint64_t first = arguments.seed;
    for (;;) {
        std::fflush(stdout);
        pid_t const player = fork();
        if (player == 0) {
            prctl(PR_SET_PDEATHSIG, SIGKILL); // without the watching process it must end
            int const status = work(arguments, first, folder, end, tally);
            std::fflush(stdout);
            _exit(status);
        }
        std::string const why = watch(player, tally);
        if (why.empty()) {
            break;
        }
        ++tally.failed;
        keep(arguments, tally.scene, folder, why);
        first = tally.scene + 1;
    }
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    std::printf("%llu scenes, %llu acts, %llu pictures, %llu different cards and buttons, %llu failed%s\n",
                static_cast<unsigned long long>(tally.scenes), static_cast<unsigned long long>(tally.acts),
                static_cast<unsigned long long>(tally.pictures), static_cast<unsigned long long>(tally.seen),
                static_cast<unsigned long long>(tally.failed), tally.grown > 0 ? ", memory GREW" : "");
    return tally.failed > 0 || tally.grown > 0 ? 1 : 0;
}
