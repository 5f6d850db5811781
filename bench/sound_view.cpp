// The cost of the rings of sound that the window draws in every run: each level with its first recorded
// solution, once without readers of its sounds and once with a subscription and the rings, as in SoundView.
//
//     bench_sound_view [LEVEL...]
// The two worlds alternate frame by frame, and their hashes must be equal. The time of each frame is the
// median of several runs, because the machine is shared. Prints Markdown, the level with the greatest cost
// last.
#include "audio/effect/hearing/rings.hpp"
#include "bench/measure.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/read/read_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace {

using namespace trembler;

constexpr std::size_t frames = 600;
constexpr std::size_t runs = 7;

/// In µs per frame.
struct Cost {
    std::string level;
    double silent = 0;     // mean
    double heard = 0;      // mean
    double worst = 0;      // of a frame: the additional time
    std::size_t rings = 0; // at most
    [[nodiscard]] double added() const { return heard - silent; }
};

std::unique_ptr<Session> openLevel(GameData const& gameData, LevelFile const& level) {
    auto session =
        std::make_unique<Session>(gameData.registry, gameData.parts, level,
                                  WorldOptions{.threads = 1, .detail = level.detail, .periods = {}});
    if (!level.solutions.empty()) {
        session->load(level.solutions.front());
    }
    session->start();
    return session;
}

Cost measure(GameData const& gameData, LevelFile const& level) {
    Cost cost;
    cost.level = level.title;
    std::vector<bench::Series> silent(frames);
    std::vector<bench::Series> heard(frames);
    for (std::size_t run = 0; run < runs; ++run) {
        auto const without = openLevel(gameData, level);
        auto const with = openLevel(gameData, level);
        Subscription const wanted = with->world().want<Sounds>();
        SoundRings rings;
        for (std::size_t frame = 0; frame < frames; ++frame) {
            auto const stepSilently = [&] { silent[frame].time([&] { without->step(); }); };
            if (frame % 2 == 0) {
                stepSilently();
            }
            heard[frame].time([&] {
                with->step();
                rings.advance(frameDuration);
                if (Sounds const* const sounds = with->world().find<Sounds>()) {
                    rings.hear(*sounds);
                }
            });
            if (frame % 2 != 0) {
                stepSilently();
            }
            cost.rings = std::max(cost.rings, rings.rings().size());
        }
        if (with->world().store().hash() != without->world().store().hash()) {
            throw std::logic_error("listening changed " + level.title);
        }
    }
    for (std::size_t frame = 0; frame < frames; ++frame) {
        double const one = 1e6 * silent[frame].median();
        double const other = 1e6 * heard[frame].median();
        cost.silent += one / frames;
        cost.heard += other / frames;
        cost.worst = std::max(cost.worst, other - one);
    }
    return cost;
}

} // namespace

int main(int argc, char** argv) {
    GameData const gameData;
    std::vector<std::filesystem::path> levels(argv + 1, argv + argc);
    if (levels.empty()) {
        levels = gameData.levels();
    }
    std::vector<Cost> all;
    for (std::filesystem::path const& path : levels) {
        all.push_back(measure(gameData, loadLevel(gameData.registry, path)));
    }
    std::stable_sort(all.begin(), all.end(),
                     [](Cost const& a, Cost const& b) { return a.added() < b.added(); });
    std::puts("| µs per frame | not computed | sounds and rings | more | worst frame | rings at most |");
    std::puts("|---|---|---|---|---|---|");
    for (Cost const& cost : all) {
        std::puts(fmt::format("| {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {} |", cost.level, cost.silent,
                              cost.heard, cost.added(), cost.worst, cost.rings)
                      .c_str());
    }
    return 0;
}
