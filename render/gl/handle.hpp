// Ownership of OpenGL's numbered objects: each is deleted exactly once, while its context is current.
#pragma once

#include <utility>

namespace trembler::render {

/// A move-only owner of one OpenGL name. Delete is a function that takes the name. Like everything that uses
/// OpenGL it belongs to the thread of the window, and must be destroyed before the window.
template <void (*Delete)(unsigned)>
class GlHandle {
public:
    GlHandle() = default;
    explicit GlHandle(unsigned name) : name_(name) {}
    GlHandle(GlHandle&& other) noexcept : name_(std::exchange(other.name_, 0U)) {}
    GlHandle& operator=(GlHandle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    GlHandle(GlHandle const&) = delete;
    GlHandle& operator=(GlHandle const&) = delete;
    ~GlHandle() {
        if (name_ != 0) {
            Delete(name_);
        }
    }

    [[nodiscard]] unsigned name() const { return name_; }

private:
    unsigned name_ = 0;
};

void deleteBuffer(unsigned name);
void deleteVertexArray(unsigned name);
void deleteTexture(unsigned name);
void deleteFramebuffer(unsigned name);
void deleteProgram(unsigned name);
void deleteShader(unsigned name);

using GlBuffer = GlHandle<deleteBuffer>;
using GlVertexArray = GlHandle<deleteVertexArray>;
using GlTexture = GlHandle<deleteTexture>;
using GlFramebuffer = GlHandle<deleteFramebuffer>;
using GlProgram = GlHandle<deleteProgram>;
using GlShader = GlHandle<deleteShader>;

/// Fresh objects; they need a current OpenGL 3.3 context.
[[nodiscard]] GlBuffer makeBuffer();
[[nodiscard]] GlVertexArray makeVertexArray();
[[nodiscard]] GlTexture makeTexture();
[[nodiscard]] GlFramebuffer makeFramebuffer();

} // namespace trembler::render
