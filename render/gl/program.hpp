// A pair of shaders, compiled and linked, with errors that name the shader and the wrong line.
#pragma once

#include "render/gl/error.hpp"
#include "render/gl/handle.hpp"

#include <initializer_list>
#include <string_view>

namespace trembler::render {

/// A linked shader program. Window thread only.
class Program {
public:
    /// Compiles and links; each shader is the concatenation of its pieces, so that shaders can share
    /// functions. `name` appears in messages. Throws RenderError with the driver's log.
    Program(std::string_view name, std::initializer_list<std::string_view> vertex,
            std::initializer_list<std::string_view> fragment);

    void use() const;

    /// Uniforms of the program in use; a name that the compiler optimised away is ignored.
    void set(char const* uniform, int value) const;
    void set(char const* uniform, float value) const;
    void set(char const* uniform, float x, float y) const;
    void set(char const* uniform, float x, float y, float z) const;

private:
    GlProgram program_;
};

} // namespace trembler::render
