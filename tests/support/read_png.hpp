// Reading pictures that the program wrote.
#pragma once

#include "render/gl/image.hpp"

#include <stb/stb_image.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace trembler::render {

/// Reads a PNG as RGBA. Throws RenderError if that does not work.
[[nodiscard]] inline Image readPng(std::filesystem::path const& file) {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::unique_ptr<stbi_uc, void (*)(void*)> const bytes(
        stbi_load(file.c_str(), &width, &height, &channels, 4), stbi_image_free);
    if (!bytes) {
        throw RenderError("The picture " + file.string() + " could not be read: " + stbi_failure_reason() +
                          ".");
    }
    Image image({width, height});
    std::copy_n(bytes.get(), image.bytes().size(), image.bytes().begin());
    return image;
}

} // namespace trembler::render
