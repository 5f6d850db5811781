#include "measure/activation/activation.hpp"

#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/read/read_level.hpp"

#include <algorithm>

namespace trembler {
namespace {

std::uint64_t updatesOf(std::vector<ComponentStatus> const& all) {
    std::uint64_t sum = 0;
    for (ComponentStatus const& status : all) {
        sum += status.updates;
    }
    return sum;
}

} // namespace

std::size_t LevelUse::constructed() const {
    return static_cast<std::size_t>(
        std::count_if(components.begin(), components.end(),
                      [](ComponentUse const& use) { return use.atEnd != Activity::absent; }));
}

LevelUse playForCalls(GameData const& gameData, LevelFile const& level, Solution const* solution,
                      int seconds) {
    Session session(gameData.registry, gameData.parts, level,
                    WorldOptions{.threads = 1, .detail = level.detail, .periods = {}});
    if (solution != nullptr) {
        session.load(*solution);
    }
    LevelUse play;
    play.title = level.title;
    play.solution = solution == nullptr ? "" : solution->name;
    std::vector<ComponentStatus> before = session.world().status();
    for (int second = 1; second <= std::max(1, seconds); ++second) {
        before = session.world().status();
        std::uint64_t const state = session.world().stateHash();
        bool const last = second >= seconds;
        play.atRest = last;
        for (std::uint64_t frame = 0; frame < framesPerSecond; ++frame) {
            session.step();
            play.atRest = play.atRest && session.world().stateHash() == state;
        }
        play.lastSecond = updatesOf(session.world().status()) - updatesOf(before);
        play.busiestSecond = std::max(play.busiestSecond, play.lastSecond);
    }
    play.frames = session.world().frame();
    std::vector<ComponentStatus> const now = session.world().status();
    for (std::size_t i = 0; i < now.size(); ++i) {
        play.components.push_back(
            {now[i].info, now[i].activity, now[i].updates, now[i].updates - before[i].updates});
    }
    return play;
}

std::vector<LevelUse> playAllForCalls(GameData const& gameData, int seconds) {
    std::vector<LevelUse> plays;
    for (std::filesystem::path const& path : gameData.levels()) {
        LevelFile const level = loadLevel(gameData.registry, path);
        std::vector<Solution const*> solutions;
        for (Solution const& solution : level.solutions) {
            solutions.push_back(&solution);
        }
        if (solutions.empty()) {
            solutions.push_back(nullptr);
        }
        for (Solution const* const solution : solutions) {
            plays.push_back(playForCalls(gameData, level, solution, seconds));
            plays.back().level = gameData.shortName(path);
        }
    }
    return plays;
}

} // namespace trembler
