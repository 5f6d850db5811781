// `trembler run --sound`, in programs with sound and in those without.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/run/runner.hpp"
#ifndef TREMBLER_HEADLESS
#include "game/ui/headless/run_sound.hpp"
#endif

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <vector>

namespace trembler {

#ifdef TREMBLER_HEADLESS

/// Stands in for ui::RunSound.
class RunSound {
public:
    RunSound(std::string const&, std::string const&, GameData const&, RunOptions&) {
        throw std::runtime_error("--sound: this build was made without sound; build it without "
                                 "-DTREMBLER_HEADLESS=ON");
    }
    void finish() {}
};

inline std::vector<std::filesystem::path> sampleFoldersOf(GameData const&, std::string const&) {
    return {};
}

#else

/// Has a run written into a .wav file. Throws std::invalid_argument for another name, OutputError if the file
/// cannot be written and std::runtime_error if there is no sound to be had. `run` must not outlive it.
class RunSound {
public:
    RunSound(std::string const& file, std::string const& level, GameData const& gameData, RunOptions& run)
        : quiet_(::setenv("ALSOFT_DRIVERS", "null", 1)),
          sound_(
              file, {.synthesiser = {}, .output = {}, .sampleFolders = ui::sampleFolders(gameData, level)},
              [](std::string const& what) { std::cerr << "trembler: " << what << "\n"; }, run) {}
    /// Puts the file in its place. Throws OutputError.
    void finish() { sound_.finish(); }

private:
    /// OpenAL asks no sound server, which would make folders in the user's home: nothing is to be played.
    int quiet_;
    ui::RunSound sound_;
};

/// Where a level's recordings are looked for.
inline std::vector<std::filesystem::path> sampleFoldersOf(GameData const& gameData,
                                                          std::string const& level) {
    return ui::sampleFolders(gameData, level);
}

#endif

} // namespace trembler
