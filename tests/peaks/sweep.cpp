// sweep_peaks: the sound of every recorded solution of every level, over its whole length, and of random
// worlds. Prints true peak, greatest step and loudest tenth of a second of each; exit status 1 if one has a
// true peak above -1 dB of full scale or a step above half of it.
//
//   sweep_peaks --worlds 500 --level turn-and-current
//   sweep_peaks --journal peaks.txt             # interrupted and started again, it goes on where it was
//   sweep_peaks --part 2/4 --journal second.txt # one of four processes that share the work
#include "runtime/level/read/read_level.hpp"
#include "tests/peaks/mix.hpp"
#include "tests/support/game_data.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>

namespace {

using namespace trembler;

constexpr std::string_view worldName = "random world ";

/// What is measured already: a line for each, its name and, behind a tab, its fault, which may be empty.
class Journal {
public:
    explicit Journal(std::string const& file) {
        if (file.empty()) {
            return;
        }
        std::ifstream before(file);
        for (std::string line; std::getline(before, line);) {
            if (std::size_t const tab = line.find('\t'); tab != std::string::npos) {
                done_[line.substr(0, tab)] = line.substr(tab + 1);
            }
        }
        out_.open(file, std::ios::app);
    }
    [[nodiscard]] bool has(std::string const& name) const { return done_.contains(name); }
    [[nodiscard]] std::uint64_t worlds() const {
        std::uint64_t count = 0;
        for (auto const& [name, fault] : done_) {
            count += name.starts_with(worldName) ? 1 : 0;
        }
        return count;
    }
    /// The first seed above those of all worlds in it.
    [[nodiscard]] std::uint64_t nextSeed() const {
        std::uint64_t next = 0;
        for (auto const& [name, fault] : done_) {
            if (name.starts_with(worldName)) {
                std::uint64_t seed = 0;
                std::from_chars(name.data() + worldName.size(), name.data() + name.size(), seed);
                next = std::max(next, seed + 1);
            }
        }
        return next;
    }
    void add(std::string const& name, std::string const& fault) {
        done_[name] = fault;
        if (out_.is_open()) {
            out_ << name << '\t' << fault << std::endl;
        }
    }
    /// Prints how many are measured, and those with a fault; whether there are none of these.
    [[nodiscard]] bool conclude() const {
        std::size_t faults = 0;
        for (auto const& [name, fault] : done_) {
            if (!fault.empty()) {
                fmt::print("{}{}: {}\n", ++faults == 1 ? "Not as they should be:\n" : "", name, fault);
            }
        }
        fmt::print("{} measured, {} of them random worlds; {} with a fault\n", done_.size(), worlds(),
                   faults);
        return faults == 0;
    }

private:
    std::map<std::string, std::string> done_;
    std::ofstream out_;
};

/// One of several processes: it takes every nth level and world.
struct Part {
    std::uint64_t number = 1;
    std::uint64_t of = 1;
    [[nodiscard]] bool has(std::uint64_t index) const { return index % of == number - 1; }
};

void report(Journal& journal, std::string const& name, peaks::Mix const& mix) {
    std::string const fault = peaks::faultOf(mix);
    fmt::print("{:>7.1f} dB {:>6.3f} {:>7.1f} dB  {}{}{}\n", mix.truePeak, mix.step, mix.loudest, name,
               fault.empty() ? "" : ": ", fault);
    std::fflush(stdout);
    journal.add(name, fault);
}

void sweepLevels(Journal& journal, Part const& part, std::string const& only) {
    constexpr std::uint64_t unstated = 600; // frames of a solution that states none
    std::uint64_t index = 0;
    for (auto const& path : gameData().levels()) {
        if (path.string().find(only) == std::string::npos || !part.has(index++)) {
            continue;
        }
        LevelFile const level = loadLevel(gameData().registry, path);
        for (Solution const& solution : level.solutions) {
            std::string const name = fmt::format("{}, {}", gameData().shortName(path), solution.name);
            if (!journal.has(name)) {
                auto const frames = static_cast<std::uint64_t>(solution.frames.value_or(unstated));
                report(journal, name,
                       peaks::mixOf(gameData().registry, gameData().parts, level, solution.name, frames));
            }
        }
    }
}

void sweepWorlds(Journal& journal, Part const& part, std::uint64_t count, std::uint64_t frames) {
    peaks::RandomMixes mixes(std::max(journal.nextSeed(), part.number - 1));
    for (std::uint64_t done = journal.worlds(); done < count; ++done) {
        auto const [seed, mix] = mixes.next(frames, [&](std::uint64_t one) { return part.has(one); });
        report(journal, fmt::format("{}{}", worldName, seed), mix);
    }
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Measures true peaks and steps of the sound of levels and random worlds."};
    std::uint64_t worlds = 500;
    std::uint64_t frames = 60;
    std::string level;
    std::string journalFile;
    std::string partText = "1/1";
    app.add_option("--worlds", worlds, "number of random worlds, of all parts together");
    app.add_option("--frames", frames, "of each random world");
    app.add_option("--level", level, "only levels whose path contains this");
    app.add_option("--journal", journalFile, "file with what is done, which is not done again");
    app.add_option("--part", partText, "K/N: every Nth level and world, beginning with the Kth");
    CLI11_PARSE(app, argc, argv);
    Part part;
    unsigned long long number = 0;
    unsigned long long of = 0;
    if (std::sscanf(partText.c_str(), "%llu/%llu", &number, &of) != 2 || number < 1 || number > of) {
        fmt::print(stderr, "--part {}: expected K/N with K from 1 to N\n", partText);
        return 2;
    }
    part = {number, of};
    setenv("ALSOFT_DRIVERS", "none of these", 1); // nothing is to be heard
    Journal journal(journalFile);
    sweepWorlds(journal, part, worlds / of + (number <= worlds % of ? 1 : 0),
                frames); // these start processes, so before any thread
    sweepLevels(journal, part, level);
    return journal.conclude() ? 0 : 1;
}
