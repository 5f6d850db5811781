// sweep_peaks: the sound of every recorded solution of every level, over its whole length, and of random
// worlds. Prints true peak, greatest step and loudest tenth of a second of each; exit status 1 if one has a
// true peak above -1 dB of full scale or a step above half of it.
//
//   sweep_peaks --worlds 500 --level turn-and-current
#include "runtime/level/read/read_level.hpp"
#include "tests/peaks/mix.hpp"
#include "tests/support/game_data.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

namespace {

using namespace trembler;

bool report(std::string const& name, peaks::Mix const& mix) {
    std::string const fault = peaks::faultOf(mix);
    fmt::print("{:>7.1f} dB {:>6.3f} {:>7.1f} dB  {}{}{}\n", mix.truePeak, mix.step, mix.loudest, name,
               fault.empty() ? "" : ": ", fault);
    std::fflush(stdout);
    return fault.empty();
}

bool sweepLevels(std::string const& only) {
    constexpr std::uint64_t unstated = 600; // frames of a solution that states none
    bool well = true;
    for (auto const& path : gameData().levels()) {
        if (path.string().find(only) == std::string::npos) {
            continue;
        }
        LevelFile const level = loadLevel(gameData().registry, path);
        for (Solution const& solution : level.solutions) {
            auto const frames = static_cast<std::uint64_t>(solution.frames.value_or(unstated));
            well =
                report(fmt::format("{}, {}", gameData().shortName(path), solution.name),
                       peaks::mixOf(gameData().registry, gameData().parts, level, solution.name, frames)) &&
                well;
        }
    }
    return well;
}

bool sweepWorlds(std::uint64_t count, std::uint64_t frames) {
    peaks::RandomMixes mixes;
    bool well = true;
    for (std::uint64_t i = 0; i < count; ++i) {
        auto const [seed, mix] = mixes.next(frames);
        well = report(fmt::format("random world {}", seed), mix) && well;
    }
    return well;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Measures true peaks and steps of the sound of levels and random worlds."};
    std::uint64_t worlds = 500;
    std::uint64_t frames = 60;
    std::string level;
    app.add_option("--worlds", worlds, "number of random worlds");
    app.add_option("--frames", frames, "of each random world");
    app.add_option("--level", level, "only levels whose path contains this");
    CLI11_PARSE(app, argc, argv);
    setenv("ALSOFT_DRIVERS", "none of these", 1);        // nothing is to be heard
    bool const worldsWell = sweepWorlds(worlds, frames); // these start processes, so before any thread
    return sweepLevels(level) && worldsWell ? 0 : 1;
}
