// Small pictures of the solutions that a search has found, each drawn once.
#pragma once

#include "puzzle/session/session.hpp"
#include "render/draw/canvas.hpp"
#include "render/gl/framebuffer.hpp"

#include <cstddef>
#include <map>
#include <memory>

namespace trembler::ui {

/// Window thread only.
class FoundPictures {
public:
    /// An OpenGL texture of the session as it is, `size` pixels; 0 if it cannot be drawn. `number` identifies
    /// the solution. Draws into a framebuffer of its own: the caller binds its target again afterwards.
    [[nodiscard]] unsigned texture(render::Canvas& canvas, std::size_t number, Session const& session,
                                   render::Size size);
    /// Before the numbers mean others.
    void forget() { pictures_.clear(); }

private:
    struct Picture {
        render::Size size;
        render::palette::Choice colours = render::palette::Choice::usual;
        std::unique_ptr<render::Framebuffer> target; // nullptr: it cannot be drawn
    };
    std::map<std::size_t, Picture> pictures_;
};

} // namespace trembler::ui
