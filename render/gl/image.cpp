#include "render/gl/image.hpp"

#include "render/gl/png.hpp"

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

void writePng(Image const& image, OutputFile& file) {
    auto const [width, height] = image.size();
    if (width == 0 || height == 0) {
        throw RenderError("An empty picture cannot be written to " + file.target().string() + ".");
    }
    auto const put = [](void* out, void* bytes, int count) {
        static_cast<std::ostream*>(out)->write(static_cast<char const*>(bytes), count);
    };
    if (stbi_write_png_to_func(put, &file.stream(), width, height, 4, image.bytes().data(), width * 4) == 0) {
        throw RenderError("The picture for " + file.target().string() +
                          " could not be made: there is not enough memory.");
    }
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
