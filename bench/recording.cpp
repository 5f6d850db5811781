// The cost of recording runs for the timeline: processor time per frame beside that of the frame itself, and
// bytes per frame, for every level with its first solution. Then the busiest level for ten minutes, in the
// memory that the game allows. CPU time of this thread.
#include "insight/timeline/recording.hpp"

#include "audio/effect/properties/sounds.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/read/read_level.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace trembler;

double cpuSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Nothing is thinned out.
constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

struct Cost {
    std::string level;
    double frameMicroseconds = 0;
    double recordMicroseconds = 0;
    double bytes = 0; // a frame
};

Cost record(GameData const& data, std::string const& path, std::uint64_t frames,
            insight::Recording& recording) {
    Session session(data.registry, data.parts, loadLevel(data.registry, path));
    if (!session.level().solutions.empty()) {
        session.load(session.level().solutions.front());
    }
    Subscription const sounds = session.world().want<Sounds>(); // as in the window
    Subscription const patches = session.world().want<ContactPatches>();
    recording.begin(session.world(), session.judge());
    double frame = 0;
    double record = 0;
    while (session.world().frame() < frames) {
        double const before = cpuSeconds();
        session.step();
        double const between = cpuSeconds();
        recording.add(session.world(), session.judge());
        frame += between - before;
        record += cpuSeconds() - between;
    }
    double const each = 1e6 / static_cast<double>(frames);
    return {std::filesystem::path(path).stem().string(), frame * each, record * each,
            static_cast<double>(recording.bytes()) / static_cast<double>(frames)};
}

} // namespace

int main() {
    GameData const data;
    std::vector<std::pair<Cost, std::string>> costs;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(TREMBLER_SOURCE_DIR "/levels")) {
        std::string const path = entry.path().string();
        try {
            insight::Recording recording(unlimited);
            costs.emplace_back(record(data, path, 1280, recording), path);
        } catch (std::exception const&) {
            continue; // no level, or one with mods
        }
    }
    std::sort(costs.begin(), costs.end(),
              [](auto const& a, auto const& b) { return a.first.bytes > b.first.bytes; });
    std::printf("%-36s %12s %12s %8s %12s\n", "level", "frame [us]", "record [us]", "share", "bytes/frame");
    for (auto const& [cost, path] : costs) {
        std::printf("%-36s %12.1f %12.1f %7.1f%% %12.0f\n", cost.level.c_str(), cost.frameMicroseconds,
                    cost.recordMicroseconds, 100 * cost.recordMicroseconds / cost.frameMicroseconds,
                    cost.bytes);
    }
    constexpr std::uint64_t tenMinutes = 36000;
    for (std::size_t i = 0; i < std::min<std::size_t>(costs.size(), 2); ++i) {
        insight::Recording whole(unlimited);
        (void)record(data, costs[i].second, tenMinutes, whole);
        insight::Recording recording;
        Cost const cost = record(data, costs[i].second, tenMinutes, recording);
        std::printf("%s, ten minutes: %.1f MiB in all, %.1f MiB kept, %zu of %llu frames\n",
                    cost.level.c_str(), static_cast<double>(whole.bytes()) / (1 << 20),
                    static_cast<double>(recording.bytes()) / (1 << 20), recording.frames(),
                    static_cast<unsigned long long>(tenMinutes + 1));
    }
    return 0;
}
