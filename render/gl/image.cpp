#include "render/gl/image.hpp"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace trembler::render {

Image::Image(Size size) : size_(size) {
    if (size.width < 0 || size.height < 0) {
        throw std::invalid_argument("A picture cannot have a negative size.");
    }
    bytes_.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 4);
}

Pixel Image::at(int x, int y) const {
    if (x < 0 || y < 0 || x >= size_.width || y >= size_.height) {
        throw std::out_of_range("There is no such pixel in the picture.");
    }
    auto const first =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(x)) *
        4;
    return {bytes_[first], bytes_[first + 1], bytes_[first + 2], bytes_[first + 3]};
}

void writePng(Image const& image, std::filesystem::path const& file) {
    auto const [width, height] = image.size();
    if (width == 0 || height == 0) {
        throw RenderError("An empty picture cannot be written to " + file.string() + ".");
    }
    if (stbi_write_png(file.c_str(), width, height, 4, image.bytes().data(), width * 4) == 0) {
        throw RenderError("The picture could not be written to " + file.string() +
                          ": is the folder there and may it be written to?");
    }
}

Image readPng(std::filesystem::path const& file) {
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
