// The option --size of the commands that draw.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace trembler {

struct PictureSize {
    int width = 0;  ///< pixels
    int height = 0; ///< pixels
};

/// "1280x720". Throws std::invalid_argument with the allowed values.
[[nodiscard]] PictureSize pictureSizeFrom(std::string const& text);
/// Adds the option; `size` holds its default.
CLI::Option* addPictureSize(CLI::App& command, std::string& size);

} // namespace trembler
