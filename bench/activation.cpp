// Shows that a scene costs time only for the effects that it activates. First: a world of a program with
// every effect, none of which the scene activates, compared with a world that has dynamics alone and with
// bare Box2D, alternating in blocks of frames. Second: every level that comes to rest, its frames at rest
// compared with its frames in motion. CPU time of this thread, medians.
#include "measure/activation/activation.hpp"

#include "bench/measure.hpp"
#include "bench/scenes/box2d_scenes.hpp"
#include "puzzle/data/effects.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/read/read_level.hpp"

#include <array>
#include <cstdlib>

namespace {

using namespace trembler;
using bench::Series;

constexpr int blockFrames = 10;
constexpr int warmUpFrames = 60;
constexpr double mostOverhead = 5; // %
constexpr double mostAtRest = 0.05;

bool noneActivated(Registry const& all, Registry const& dynamicsAlone, bench::SceneOf const& scene,
                   int repetitions) {
    std::array<Series, 3> times; // bare Box2D, dynamics alone, all effects
    Series overhead;
    Series rest;
    bool same = true;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        bench::Bare bare(scene);
        bench::Trembler alone(dynamicsAlone, scene);
        bench::Trembler everything(all, scene);
        for (int frame = 0; frame < warmUpFrames; ++frame) {
            bare.step();
            alone.step();
            everything.step();
        }
        for (int block = 0; block < scene.blocks; ++block) {
            std::array<double, 3> took{};
            for (int turn = 0; turn < 3; ++turn) { // each world is the first in a third of the blocks
                switch ((turn + block) % 3) {
                case 0:
                    took[0] = bench::timeBlock(bare, blockFrames);
                    break;
                case 1:
                    took[1] = bench::timeBlock(alone, blockFrames);
                    break;
                default:
                    took[2] = bench::timeBlock(everything, blockFrames);
                }
            }
            for (std::size_t i = 0; i < took.size(); ++i) {
                times[i].add(took[i]);
            }
            overhead.add(took[2] / took[0]);
            rest.add(took[2] / took[1]);
        }
        same = same && bare.places() == everything.places() && alone.places() == everything.places();
    }
    // Other load on the machine slows all worlds, but not always equally: so the limit applies to the fastest
    // tenth of the blocks of each.
    double const fastest = times[2].quantile(0.1) / times[0].quantile(0.1);
    double const percent = 100 * (fastest - 1);
    bench::Table table(scene.name + " without gravity: all other effects registered, none activated");
    table.row("bare Box2D, per frame", 1e6 * times[0].median(), "us");
    table.row("a world that knows dynamics alone", 1e6 * times[1].median(), "us");
    table.row("a world that knows every effect", 1e6 * times[2].median(), "us");
    table.row("every effect against dynamics alone", 100 * (rest.median() - 1), "%");
    table.row("overhead, median", 100 * (overhead.median() - 1), "%");
    table.row("overhead, fastest tenth of the blocks", percent, "%", percent, mostOverhead);
    table.print();
    std::printf("  motion is %s\n\n",
                same ? "the same, bit for bit" : "NOT THE SAME: the comparison is void");
    return same && percent <= mostOverhead;
}

/// Seconds per frame of one play, one value per second of the run.
std::vector<double> secondsOf(GameData const& gameData, LevelFile const& level, Solution const* solution,
                              int seconds) {
    Session session(gameData.registry, gameData.parts, level,
                    WorldOptions{.threads = 1, .detail = level.detail, .periods = {}});
    if (solution != nullptr) {
        session.load(*solution);
    }
    std::vector<double> times;
    for (int second = 0; second < seconds; ++second) {
        World const& world = session.world();
        double const before = bench::cpuSeconds();
        for (std::uint64_t frame = 0; frame < framesPerSecond; ++frame) {
            session.step();
        }
        times.push_back((bench::cpuSeconds() - before) / static_cast<double>(framesPerSecond));
        bench::keep(world);
    }
    return times;
}

bool atRest(GameData const& gameData, int repetitions) {
    constexpr int seconds = 20;
    double worst = 0;
    bench::Table table(
        "Levels that come to rest within 20 s: a frame at rest against one of the busiest second");
    for (std::filesystem::path const& path : gameData.levels()) {
        LevelFile const level = loadLevel(gameData.registry, path);
        Solution const* const solution = level.solutions.empty() ? nullptr : &level.solutions.front();
        if (!playForCalls(gameData, level, solution, seconds).atRest) {
            continue;
        }
        std::vector<Series> bySecond(seconds);
        for (int repetition = 0; repetition < 3 * repetitions; ++repetition) {
            std::vector<double> const times = secondsOf(gameData, level, solution, seconds);
            for (std::size_t i = 0; i < times.size(); ++i) {
                bySecond[i].add(times[i]);
            }
        }
        double busiest = 0;
        for (Series const& second : bySecond) {
            busiest = std::max(busiest, second.median());
        }
        double const resting = bySecond.back().median();
        worst = std::max(worst, resting / busiest);
        std::string const name = path.stem().string();
        table.row(name + ", in motion", 1e6 * busiest, "us per frame");
        table.row(name + ", at rest", 1e6 * resting, "us per frame");
    }
    table.row("greatest share", worst, "", worst, mostAtRest);
    table.print();
    return worst <= mostAtRest;
}

} // namespace

// bench_activation [repetitions]; exit status 1 if a limit is exceeded.
int main(int argc, char** argv) {
    int const repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
    Registry all;
    registerEffects(all);
    Registry dynamicsAlone;
    registerEffects(dynamicsAlone, dispensableGameEffects());
    bool held = true;
    for (bench::SceneOf scene : {bench::largePyramid(), bench::tumbler()}) {
        scene.gravity = 0;
        held = noneActivated(all, dynamicsAlone, scene, repetitions) && held;
    }
    GameData const gameData;
    held = atRest(gameData, repetitions) && held;
    return held ? 0 : 1;
}
