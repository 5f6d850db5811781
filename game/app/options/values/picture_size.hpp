// The option --size of the commands that draw.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace trembler {

struct PictureSize {
    int width = 0;  ///< pixels
    int height = 0; ///< pixels
};

/// "1280x720"; nothing if the text is anything else, or a side or the area is not allowed.
[[nodiscard]] std::optional<PictureSize> pictureSizeFrom(std::string const& text);
/// Adds the option; `size` holds its default.
CLI::Option* addPictureSize(CLI::App& command, std::string& size);

} // namespace trembler
