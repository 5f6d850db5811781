#include "render/gl/framebuffer.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace trembler::render {

Framebuffer::Framebuffer(Size size) : size_(size) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (size.width <= 0 || size.height <= 0 || size.width > largest || size.height > largest) {
        throw RenderError("A picture of " + std::to_string(size.width) + " by " +
                          std::to_string(size.height) +
                          " pixels cannot be drawn: this graphics driver does 1 to " +
                          std::to_string(largest) + " each way.");
    }
    texture_ = makeTexture();
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    framebuffer_ = makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
    bool const complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!complete) {
        throw RenderError("The graphics driver cannot draw into a picture in memory.");
    }
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, size_.width, size_.height);
}

Image Framebuffer::read() const {
    GLint before = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &before);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    auto image = readBoundPixels(size_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(before));
    return image;
}

void clearBound(Colour colour) {
    auto const channel = [](std::uint8_t value) { return static_cast<float>(value) / 255.F; };
    glDisable(GL_SCISSOR_TEST);
    glClearColor(channel(colour.red), channel(colour.green), channel(colour.blue), channel(colour.alpha));
    glClear(GL_COLOR_BUFFER_BIT);
}

Image readBoundPixels(Size size) {
    Image image(size);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, image.bytes().data());
    auto& bytes = image.bytes();
    auto const row = static_cast<std::ptrdiff_t>(size.width) * 4;
    // OpenGL's first row is the bottom one.
    std::vector<std::uint8_t> kept(static_cast<std::size_t>(row));
    for (int top = 0, bottom = size.height - 1; top < bottom; ++top, --bottom) {
        std::copy_n(bytes.begin() + top * row, row, kept.begin());
        std::copy_n(bytes.begin() + bottom * row, row, bytes.begin() + top * row);
        std::copy_n(kept.begin(), row, bytes.begin() + bottom * row);
    }
    for (std::size_t i = 3; i < bytes.size(); i += 4) {
        bytes[i] = 255;
    }
    return image;
}

} // namespace trembler::render
