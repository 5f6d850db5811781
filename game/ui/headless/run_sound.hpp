// What a run without a window sounds like, as a file: `trembler run --sound`.
#pragma once

#include "audio/device/sound_file.hpp"
#include "puzzle/run/runner.hpp"

#include <filesystem>
#include <vector>

namespace trembler {

struct GameData;

namespace ui {

/// Where recordings are looked for: beside the level (empty: none), beside the program's levels, among its
/// own sounds.
[[nodiscard]] std::vector<std::filesystem::path> sampleFolders(GameData const& gameData,
                                                               std::filesystem::path const& level);

/// Hears a level from where a player sees all of it: in front of the middle of its bounds, as far away as
/// they are high. A level without bounds is heard from the middle of where its objects begin.
[[nodiscard]] Listener listenerFor(LevelFile const& level, World const& world);

/// Has a run written into a sound file; see SoundFile for what that may throw. `run` must not outlive it.
class RunSound {
public:
    RunSound(std::filesystem::path const& file, LoudspeakerOptions const& options, Loudspeaker::Tell tell,
             RunOptions& run);
    /// Completes the file.
    void finish() { file_.finish(); }

private:
    SoundFile file_;
    Listener listener_;
};

} // namespace ui
} // namespace trembler
