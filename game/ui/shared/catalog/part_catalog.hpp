// Prototypes of parts for the window, each made once from its definition, with a small picture.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/gl/framebuffer.hpp"
#include "render/scene/facts/pick.hpp"
#include "runtime/level/model/part_library.hpp"

#include <map>
#include <string>
#include <vector>

namespace trembler::ui {

/// Window thread only; the library and the canvas must outlive it.
class PartCatalog {
public:
    PartCatalog(PartLibrary const& parts, render::Canvas& canvas) : parts_(parts), canvas_(canvas) {}

    /// The part's name for the player.
    [[nodiscard]] std::string titleOf(std::string const& part) const;
    /// The part's description, "" if it has none.
    [[nodiscard]] std::string textOf(std::string const& part) const;
    /// The groups of a large toolbox that have the part; valid as long as the catalogue.
    [[nodiscard]] std::vector<PartGroup> const& groupsOf(std::string const& part);
    /// nullptr if there is no such part.
    [[nodiscard]] Prototype const* prototype(std::string const& part);
    /// An OpenGL texture of the part lying on a tile, `pixels` wide and high; 0 if there is no such part.
    /// Draws into its own framebuffer: the caller must bind its target again afterwards.
    [[nodiscard]] unsigned picture(std::string const& part, int pixels);
    /// Distance from the part's middle to its farthest point, m.
    [[nodiscard]] double radius(std::string const& part);

private:
    struct Picture {
        int pixels = 0;
        render::palette::Choice colours = render::palette::Choice::usual;
        std::unique_ptr<render::Framebuffer> target;
    };

    PartLibrary const& parts_;
    render::Canvas& canvas_;
    std::map<std::string, Prototype> prototypes_;
    std::map<std::string, std::vector<PartGroup>> groups_;
    std::map<std::string, Picture> pictures_;
};

} // namespace trembler::ui
