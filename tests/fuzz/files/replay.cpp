#include "puzzle/session/session.hpp"
#include "puzzle/solutions/solution_file.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/level/write/write_level.hpp"
#include "tests/fuzz/files/kit.hpp"
#include "tests/fuzz/play.hpp"
#include "tests/fuzz/targets.hpp"

#include <nlohmann/json.hpp>

namespace trembler::files {
namespace {

constexpr int replayFrames = 60;

/// The recordings of the corpus are of this level.
LevelFile const& recordedLevel() {
    static LevelFile const level = loadLevel(gameData().registry, std::filesystem::path(TREMBLER_SOURCE_DIR) /
                                                                      "levels/experiments/2-doorbell.json");
    return level;
}

Solution read(std::string_view bytes) {
    std::filesystem::path const file = ownFolder() / "replay.json";
    write(file, bytes);
    return findOrLoadSolution(gameData().registry, recordedLevel(), file.string());
}

std::uint64_t hashAtTheEnd(Session& session, Solution const& solution) {
    session.load(solution);
    for (int frame = 0; frame < replayFrames; ++frame) {
        session.step();
    }
    return session.world().stateHash();
}

} // namespace

void fuzzReplay(std::string_view bytes) {
    try {
        LevelFile const& level = recordedLevel();
        Solution const solution = read(bytes);
        Session session(gameData().registry, gameData().parts, level);
        std::uint64_t const hash = hashAtTheEnd(session, solution);
        if (session.whyNotRecorded()) {
            return;
        }
        // A recording of the replay is the same replay.
        Solution const again = read(writeSolution(session.record("again")).dump());
        Session other(gameData().registry, gameData().parts, level);
        lua::require(hashAtTheEnd(other, again) == hash, "a recording of a replay is another replay");
    } catch (InputError const& error) {
        requireWords(error);
    }
}

} // namespace trembler::files
