// Pictures in main memory: read back from the screen, compared in tests and written as PNG.
#pragma once

#include "render/gl/error.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace trembler::render {

/// A width and a height in pixels (or in window points where a comment says so); both are at least 0.
struct Size {
    int width = 0;
    int height = 0;

    friend bool operator==(Size const&, Size const&) = default;
};

/// Red, green, blue, opacity; 0 to 255 each, not premultiplied.
using Pixel = std::array<std::uint8_t, 4>;

/// 8-bit RGBA, rows from top to bottom without padding. Plain data: usable from any thread.
class Image {
public:
    Image() = default;
    /// Transparent black. Throws std::invalid_argument for a negative size.
    explicit Image(Size size);

    [[nodiscard]] Size size() const { return size_; }
    [[nodiscard]] std::vector<std::uint8_t> const& bytes() const { return bytes_; }
    [[nodiscard]] std::vector<std::uint8_t>& bytes() { return bytes_; }

    /// The pixel in column x and row y, counted from the top left. Throws std::out_of_range outside the
    /// picture.
    [[nodiscard]] Pixel at(int x, int y) const;

    friend bool operator==(Image const&, Image const&) = default;

private:
    Size size_{};
    std::vector<std::uint8_t> bytes_;
};

/// Writes the picture as a PNG and replaces a file of that name. Throws RenderError if the file cannot be
/// written or the picture is empty.
void writePng(Image const& image, std::filesystem::path const& file);

} // namespace trembler::render
