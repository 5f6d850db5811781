// Writes the player's clips and single pictures.
#pragma once

#include "render/gl/image.hpp"
#include "render/gl/webp.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace trembler::ui {

/// Window thread only.
class Recorder {
public:
    /// Clips and pictures go into files below `folder`.
    explicit Recorder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Makes the folder, so that a clip is not recorded that cannot be saved. Throws RenderError with a
    /// message for the player if that is not possible.
    void prepare() const;
    /// Writes a clip, "clip-1.webp" and so on, whose last picture is shown until `milliseconds`; returns its
    /// path. Throws RenderError or OutputError.
    [[nodiscard]] std::filesystem::path clip(render::AnimatedWebp& clip, std::int64_t milliseconds) const;
    /// Writes a text, NAME-1 with that ending and so on, and returns its path. Throws RenderError or
    /// OutputError.
    [[nodiscard]] std::filesystem::path writeText(std::string const& name, char const* ending,
                                                  std::string const& content) const;
    /// Writes a single picture, "picture-1.png" and so on, and returns its path. Throws RenderError.
    std::filesystem::path picture(render::Image const& image);

private:
    std::filesystem::path folder_;
};

} // namespace trembler::ui
