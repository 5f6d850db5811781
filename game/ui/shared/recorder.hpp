// Writes pictures that the player takes: films as numbered PNG files, and single pictures.
#pragma once

#include "render/gl/image.hpp"
#include "runtime/level/model/level.hpp"

#include <filesystem>
#include <string>

namespace trembler::ui {

/// Writes the frames of each film into a new folder. Window thread only.
class Recorder {
public:
    /// Films and pictures go into folders and files below `folder`.
    explicit Recorder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    [[nodiscard]] bool recording() const { return recording_; }
    [[nodiscard]] int frames() const { return frames_; }
    /// Folder of the current or last film.
    [[nodiscard]] std::filesystem::path const& film() const { return film_; }

    /// Starts a film in a new folder: "film-1", "film-2" ... Throws RenderError with a message for the player
    /// if the folder cannot be created.
    void start();
    void stop() { recording_ = false; }
    /// Adds a frame as frame-00001.png and so on. Throws RenderError if it cannot be written; that ends the
    /// film.
    void add(render::Image const& image);
    /// Writes a single picture, "picture-1.png" and so on, and returns its path. Throws RenderError.
    std::filesystem::path picture(render::Image const& image);
    /// Writes a solution file for `trembler run --solution FILE`, "LEVEL-solution-1.json" and so on, and
    /// returns its path. Throws RenderError.
    std::filesystem::path solution(Solution const& solution, std::string const& level);

private:
    std::filesystem::path folder_;
    std::filesystem::path film_;
    bool recording_ = false;
    int frames_ = 0;
};

} // namespace trembler::ui
