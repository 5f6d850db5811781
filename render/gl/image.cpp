#include "render/gl/image.hpp"

#include "render/gl/png.hpp"

#include <stb_image_write.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

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

namespace {

/// `called`: what is to be written, for messages.
void encodePng(Image const& image, std::ostream& out, std::string const& called) {
    auto const [width, height] = image.size();
    if (width == 0 || height == 0) {
        throw RenderError("An empty picture cannot be written to " + called + ".");
    }
    auto const put = [](void* stream, void* bytes, int count) {
        static_cast<std::ostream*>(stream)->write(static_cast<char const*>(bytes), count);
    };
    if (stbi_write_png_to_func(put, &out, width, height, 4, image.bytes().data(), width * 4) == 0) {
        throw RenderError("The picture for " + called + " could not be made: there is not enough memory.");
    }
}

} // namespace

void writePng(Image const& image, OutputFile& file) {
    encodePng(image, file.stream(), file.target().string());
}

std::string pngOf(Image const& image) {
    std::ostringstream out;
    encodePng(image, out, "a file");
    return std::move(out).str();
}

void writePng(Image const& image, std::filesystem::path const& file) {
    try {
        OutputFile out(file, OutputFile::Content::binary);
        writePng(image, out);
        out.commit();
    } catch (OutputError const& error) {
        throw RenderError(std::string("The picture ") + error.what() + ".");
    }
}

} // namespace trembler::render
