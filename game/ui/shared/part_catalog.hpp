// Parts as the window needs them: made once from their definitions, with a small picture of each.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/gl/framebuffer.hpp"
#include "render/scene/facts/pick.hpp"
#include "runtime/level/model/part_library.hpp"

#include <map>
#include <string>

namespace trembler::ui {

/// Window thread only; the library and the canvas must outlive it.
class PartCatalog {
public:
    PartCatalog(PartLibrary const& parts, render::Canvas& canvas) : parts_(parts), canvas_(canvas) {}

    /// What the player calls a part.
    [[nodiscard]] std::string titleOf(std::string const& part) const;
    /// What it does, "" if nobody says.
    [[nodiscard]] std::string textOf(std::string const& part) const;
    /// nullptr if there is no such part.
    [[nodiscard]] Prototype const* prototype(std::string const& part);
    /// An OpenGL texture of the part lying on a tile, `pixels` wide and high; 0 if there is no such part.
    /// Draws into a picture of its own: the caller binds its target again afterwards.
    [[nodiscard]] unsigned picture(std::string const& part, int pixels);
    /// Distance from the part's middle to its farthest point, m.
    [[nodiscard]] double radius(std::string const& part);

private:
    struct Picture {
        int pixels = 0;
        std::unique_ptr<render::Framebuffer> target;
    };

    PartLibrary const& parts_;
    render::Canvas& canvas_;
    std::map<std::string, Prototype> prototypes_;
    std::map<std::string, Picture> pictures_;
};

} // namespace trembler::ui
