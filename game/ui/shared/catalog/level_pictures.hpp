// Small pictures of levels as they are when they are opened, drawn by the program itself and kept.
#pragma once

#include "game/ui/shared/catalog/level_catalog.hpp"
#include "render/draw/canvas.hpp"
#include "render/gl/framebuffer.hpp"
#include "runtime/level/model/part_library.hpp"

#include <map>
#include <memory>
#include <string>

namespace trembler::ui {

/// Window thread only; everything must outlive it.
class LevelPictures {
public:
    /// `data`: see CatalogMods::data.
    LevelPictures(Registry const& registry, PartLibrary const& parts, render::Canvas& canvas,
                  decltype(CatalogMods::data) data);

    /// To be called once per picture of the window: allows one more level to be drawn in it, so that a page
    /// of many levels appears at once and fills.
    void beginFrame() { mayDraw_ = true; }
    /// An OpenGL texture of the level, `size` pixels; 0 while there is none: it has not been drawn yet, or
    /// it cannot be. Draws into a framebuffer of its own: the caller binds its target again afterwards.
    [[nodiscard]] unsigned texture(CatalogEntry const& level, render::Size size);
    /// Whether a picture that was asked for has not been drawn yet.
    [[nodiscard]] bool waiting() const { return waiting_; }
    /// Forgets all requests for pictures; a picture that is requested again waits again.
    void forgetWaiting() { waiting_ = false; }

private:
    struct Picture {
        render::Size size;
        render::palette::Choice colours = render::palette::Choice::usual;
        std::unique_ptr<render::Framebuffer> target; // nullptr: it cannot be drawn
    };
    void drawInto(render::Framebuffer const& target, CatalogEntry const& level);

    Registry const& registry_;
    PartLibrary const& parts_;
    render::Canvas& canvas_;
    decltype(CatalogMods::data) data_;
    std::map<std::string, Picture> pictures_; // by level id
    bool mayDraw_ = true;
    bool waiting_ = false;
};

} // namespace trembler::ui
