// Writes the sound of a run without a window to a file: `trembler run --sound`.
#pragma once

#include "audio/device/sound_file.hpp"
#include "puzzle/run/runner.hpp"

#include <filesystem>
#include <vector>

namespace trembler {

struct GameData;

namespace ui {

/// Folders in which recordings are looked for: beside the level (empty: none), beside the program's levels,
/// and the program's own sounds.
[[nodiscard]] std::vector<std::filesystem::path> sampleFolders(GameData const& gameData,
                                                               std::filesystem::path const& level);

/// A listener at the place from which a player sees the whole level: in front of the middle of its bounds, at
/// a distance of their height (0.5 to 50 m). For a level without bounds, the bounding box of the objects'
/// initial positions is used.
[[nodiscard]] Listener listenerFor(LevelFile const& level, World const& world);

/// Writes a run's sound into a file; throws as SoundFile does. `run` must not outlive it.
class RunSound {
public:
    RunSound(std::filesystem::path const& file, LoudspeakerOptions const& options, Loudspeaker::Report report,
             RunOptions& run);
    /// Completes the file.
    void finish() { file_.finish(); }

private:
    SoundFile file_;
    Listener listener_;
};

} // namespace ui
} // namespace trembler
