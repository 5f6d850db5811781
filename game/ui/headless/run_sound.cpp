#include "game/ui/headless/run_sound.hpp"

#include "puzzle/data/game_data.hpp"
#include "runtime/placement.hpp"

#include <algorithm>

namespace trembler::ui {

namespace fs = std::filesystem;

std::vector<fs::path> sampleFolders(GameData const& gameData, fs::path const& level) {
    std::vector<fs::path> folders;
    if (!level.empty()) {
        folders.push_back(level.parent_path());
    }
    for (fs::path const& known : gameData.levels()) {
        if (folders.empty() || folders.back() != known.parent_path()) {
            folders.push_back(known.parent_path());
        }
    }
    folders.push_back(gameData.home / "assets" / "sounds");
    return folders;
}

Listener listenerFor(LevelFile const& level, World const& world) {
    Vec2 low;
    Vec2 high;
    if (level.bounds) {
        low = level.bounds->corner;
        high = low + level.bounds->size;
    } else if (auto const* const places = world.store().findColumn<Position>();
               places != nullptr && !places->empty()) {
        low = high = places->values().front().value;
        for (Position const& place : places->values()) {
            low = {std::min(low.x, place.value.x), std::min(low.y, place.value.y)};
            high = {std::max(high.x, place.value.x), std::max(high.y, place.value.y)};
        }
    }
    return {.at = (low + high) / 2, .height = std::clamp(high.y - low.y, 0.5, 50.0), .velocity = {}};
}

RunSound::RunSound(fs::path const& file, LoudspeakerOptions const& options, Loudspeaker::Report report,
                   RunOptions& run)
    : file_(file, options, std::move(report)) {
    run.enter = [this](Session& session) {
        listener_ = listenerFor(session.level(), session.world());
        file_.enter(session.world());
    };
    run.frame = [this](World const& world) { file_.frame(world, listener_); };
}

} // namespace trembler::ui
