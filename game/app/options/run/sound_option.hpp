// `trembler run --sound`, for programs built with and without sound.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/run/runner.hpp"
#include "runtime/file/output_file.hpp"
#ifndef TREMBLER_HEADLESS
#include "audio/device/sound_file.hpp"
#include "game/ui/headless/run_sound.hpp"
#endif

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <vector>

namespace trembler {

#ifdef TREMBLER_HEADLESS

/// Replaces ui::RunSound in programs without sound.
class RunSound {
public:
    RunSound(std::string const&, std::string const&, GameData const&, RunOptions&) {
        throw std::runtime_error("--sound: this build was made without sound; build it without "
                                 "-DTREMBLER_HEADLESS=ON");
    }
    [[nodiscard]] static std::uint64_t mostFrames() { return std::numeric_limits<std::uint64_t>::max(); }
    void finish() {}
};

inline std::vector<std::filesystem::path> sampleFoldersOf(GameData const&, std::string const&) {
    return {};
}

#else

/// Writes the sound of a run into a .wav file. Throws std::invalid_argument for another file extension and
/// OutputError if the file cannot be written, both with the option's name, and std::runtime_error if OpenAL
/// is not available. `run` must not outlive it.
class RunSound {
public:
    RunSound(std::string const& file, std::string const& level, GameData const& gameData, RunOptions& run) try
        : quiet_(::setenv("ALSOFT_DRIVERS", "null", 1)),
          sound_(
              file, {.synthesiser = {}, .output = {}, .sampleFolders = ui::sampleFolders(gameData, level)},
              [](std::string const& what) { std::cerr << "trembler: " << what << "\n"; }, run) {
    } catch (OutputError const& error) {
        throw OutputError(std::string("--sound ") + error.what());
    } catch (std::invalid_argument const& error) {
        throw std::invalid_argument(std::string("--sound ") + error.what());
    }
    /// The longest run whose sound a file has room for.
    [[nodiscard]] static std::uint64_t mostFrames() {
        return SoundFile::mostFrames(SynthesiserOptions().rate);
    }
    /// Puts the file in its final place. Throws OutputError.
    void finish() {
        try {
            sound_.finish();
        } catch (OutputError const& error) {
            throw OutputError(std::string("--sound ") + error.what());
        }
    }

private:
    /// Keeps OpenAL from contacting a sound server, which would create folders in the user's home: nothing is
    /// played.
    int quiet_;
    ui::RunSound sound_;
};

/// The folders in which a level's recordings are looked for.
inline std::vector<std::filesystem::path> sampleFoldersOf(GameData const& gameData,
                                                          std::string const& level) {
    return ui::sampleFolders(gameData, level);
}

#endif

} // namespace trembler
