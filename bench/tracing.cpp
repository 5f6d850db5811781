// The cost of tracing a run for `trembler why`: time of all frames of each level without input, with and
// without a trace. Without one, an event costs a test of a null pointer. Processor time, one thread: some
// levels' 600 frames take less than a millisecond, in which any other work on the processor would count more
// than the trace. bench_tracing NAME... measures only levels whose names contain one of these.
#include "bench/measure.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/read/read_level.hpp"

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

namespace {

using namespace trembler;

constexpr int frames = 600;
constexpr int repetitions = 15;

double processorSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void runOnce(GameData const& data, LevelFile const& level, bool trace, bench::Series& series) {
    WorldOptions options;
    options.detail = level.detail;
    options.trace = trace;
    Session session(data.registry, data.parts, level, options);
    double const begin = processorSeconds();
    for (int frame = 0; frame < frames; ++frame) {
        session.step();
    }
    series.add(processorSeconds() - begin);
    bench::keep(session.world().frame());
}

} // namespace

int main(int count, char** arguments) {
    std::vector<std::string> const wanted(arguments + 1, arguments + count);
    GameData const data;
    bench::Table table("Tracing a run: share of a frame's time");
    std::vector<double> shares;
    for (auto const& file : data.levels()) {
        std::string const name = data.shortName(file);
        if (!wanted.empty() && std::none_of(wanted.begin(), wanted.end(), [&](std::string const& part) {
                return name.find(part) != std::string::npos;
            })) {
            continue;
        }
        LevelFile const level = loadLevel(data.registry, file);
        if (!level.mods.empty()) {
            continue;
        }
        bench::Series plain;
        bench::Series traced;
        for (int i = 0; i < repetitions; ++i) {
            runOnce(data, level, false, plain);
            runOnce(data, level, true, traced);
        }
        double const share = 100 * (traced.quantile(0.2) / plain.quantile(0.2) - 1);
        shares.push_back(share);
        table.row(name, share, "%");
    }
    std::sort(shares.begin(), shares.end());
    double const middle = shares.empty() ? 0 : shares[shares.size() / 2];
    table.row("the median of all levels", middle, "%", middle, 10);
    table.print();
    return 0;
}
