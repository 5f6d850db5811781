// Pictures that the player takes: a film as numbered PNG files, and single ones.
#pragma once

#include "render/gl/image.hpp"
#include "runtime/level/model/level.hpp"

#include <filesystem>
#include <string>

namespace trembler::ui {

/// Writes frames into a new folder per film. Window thread only.
class Recorder {
public:
    /// Films and pictures go into folders and files below `folder`.
    explicit Recorder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    [[nodiscard]] bool recording() const { return recording_; }
    [[nodiscard]] int frames() const { return frames_; }
    /// Where the present or last film is.
    [[nodiscard]] std::filesystem::path const& film() const { return film_; }

    /// Begins a film in a folder that is not there yet: "film-1", "film-2" ... Throws RenderError with a
    /// message for the player if it cannot be made.
    void start();
    void stop() { recording_ = false; }
    /// Adds a picture as frame-00001.png and so on. Throws RenderError if it cannot be written; the film is
    /// then over.
    void add(render::Image const& image);
    /// Writes a single picture, "picture-1.png" and so on, and returns where. Throws RenderError.
    std::filesystem::path picture(render::Image const& image);
    /// Writes a solution as `trembler run --solution FILE` takes it, "LEVEL-solution-1.json" and so on, and
    /// returns where. Throws RenderError.
    std::filesystem::path solution(Solution const& solution, std::string const& level);

private:
    std::filesystem::path folder_;
    std::filesystem::path film_;
    bool recording_ = false;
    int frames_ = 0;
};

} // namespace trembler::ui
