// Moving pictures: an animated WebP of pictures in main memory.
#pragma once

#include "render/gl/image.hpp"
#include "runtime/file/output_file.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace trembler::render {

/// Compresses pictures one after another and keeps only the result in memory. One thread at a time.
class AnimatedWebp {
public:
    /// The longest side that the format allows, pixels.
    static constexpr int largestSide = 16383;

    /// All pictures have this size. Throws RenderError if the format does not allow it.
    explicit AnimatedWebp(Size size);
    ~AnimatedWebp();
    AnimatedWebp(AnimatedWebp const&) = delete;
    AnimatedWebp& operator=(AnimatedWebp const&) = delete;

    /// Adds a picture, which is shown from `milliseconds` after the beginning; ascending. Throws RenderError
    /// if it has another size, or cannot be compressed.
    void add(Image const& image, std::int64_t milliseconds);
    [[nodiscard]] int pictures() const { return pictures_; }
    /// Writes all pictures, which then repeat for ever; the last one is shown until `milliseconds`. Nothing
    /// can be added afterwards. Throws RenderError if there is no picture. Errors of writing are reported by
    /// the file when it is committed.
    void write(OutputFile& file, std::int64_t milliseconds);
    /// The same as the content of a file.
    [[nodiscard]] std::string bytes(std::int64_t milliseconds);

private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
    Size size_;
    int pictures_ = 0;
};

} // namespace trembler::render
