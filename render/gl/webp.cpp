#include "render/gl/webp.hpp"

#include <fmt/format.h>

#include <string>
#include <webp/encode.h>
#include <webp/mux.h>

namespace trembler::render {

struct AnimatedWebp::Encoder {
    WebPAnimEncoder* encoder = nullptr;
    WebPConfig config{};

    ~Encoder() { WebPAnimEncoderDelete(encoder); }
    [[noreturn]] void refuse() const {
        throw RenderError(
            fmt::format("the moving picture cannot be made: {}", WebPAnimEncoderGetError(encoder)));
    }
};

AnimatedWebp::AnimatedWebp(Size size) : encoder_(std::make_unique<Encoder>()), size_(size) {
    bool const possible =
        size.width > 0 && size.height > 0 && size.width <= largestSide && size.height <= largestSide;
    WebPAnimEncoderOptions options;
    if (!possible || WebPConfigInit(&encoder_->config) == 0 || WebPAnimEncoderOptionsInit(&options) == 0) {
        throw RenderError(
            fmt::format("a moving picture of {} x {} pixels cannot be made", size.width, size.height));
    }
    encoder_->config.quality = 80;
    encoder_->config.method = 2; // compresses while the picture is drawn: speed matters more than size
    options.anim_params.loop_count = 0;
    encoder_->encoder = WebPAnimEncoderNew(size.width, size.height, &options);
    if (encoder_->encoder == nullptr) {
        throw RenderError("the moving picture cannot be made: there is too little memory");
    }
}

AnimatedWebp::~AnimatedWebp() = default;

void AnimatedWebp::add(Image const& image, std::int64_t milliseconds) {
    if (!(image.size() == size_)) {
        throw RenderError("the pictures of a moving picture must have the same size");
    }
    WebPPicture picture;
    if (WebPPictureInit(&picture) == 0) {
        throw RenderError("this libwebp is not the one that the program was built with");
    }
    picture.width = size_.width;
    picture.height = size_.height;
    picture.use_argb = 1;
    bool const added = WebPPictureImportRGBX(&picture, image.bytes().data(), 4 * size_.width) != 0 &&
                       WebPAnimEncoderAdd(encoder_->encoder, &picture, static_cast<int>(milliseconds),
                                          &encoder_->config) != 0;
    WebPPictureFree(&picture);
    if (!added) {
        encoder_->refuse();
    }
    ++pictures_;
}

std::string AnimatedWebp::bytes(std::int64_t milliseconds) {
    WebPData data;
    WebPDataInit(&data);
    if (WebPAnimEncoderAdd(encoder_->encoder, nullptr, static_cast<int>(milliseconds), nullptr) == 0 ||
        WebPAnimEncoderAssemble(encoder_->encoder, &data) == 0) {
        encoder_->refuse();
    }
    std::string content(reinterpret_cast<char const*>(data.bytes), data.size); // NOLINT
    WebPDataClear(&data);
    return content;
}

void AnimatedWebp::write(OutputFile& file, std::int64_t milliseconds) {
    file.stream() << bytes(milliseconds);
}

} // namespace trembler::render
