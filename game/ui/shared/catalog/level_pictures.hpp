// Small pictures of levels as they are when they are opened, drawn by the program itself and kept.
#pragma once

#include "game/ui/shared/catalog/level_catalog.hpp"
#include "render/draw/canvas.hpp"
#include "render/gl/framebuffer.hpp"
#include "runtime/level/model/part_library.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace trembler::ui {

/// Window thread only; everything must outlive it.
class LevelPictures {
public:
    /// As many as no page shows at once.
    static constexpr std::size_t usuallyKept = 500;

    /// `data`: see CatalogMods::data. Of more pictures than `mostKept` the one that was not asked for longest
    /// is forgotten.
    LevelPictures(Registry const& registry, PartLibrary const& parts, render::Canvas& canvas,
                  decltype(CatalogMods::data) data, std::size_t mostKept = usuallyKept);

    /// To be called once per picture of the window: allows one more level to be drawn in it, so that a page
    /// of many levels appears at once and fills.
    void beginFrame() { mayDraw_ = true; }
    /// An OpenGL texture of the level, `size` pixels; 0 while there is none: it has not been drawn yet, or
    /// it cannot be. Draws into a framebuffer of its own: the caller binds its target again afterwards.
    [[nodiscard]] unsigned texture(CatalogEntry const& level, render::Size size);
    /// Why the level that texture() was asked for last cannot be played, if that has just turned out.
    [[nodiscard]] std::optional<std::string> takeTrouble() { return std::exchange(trouble_, {}); }
    [[nodiscard]] std::size_t kept() const { return pictures_.size(); }
    /// Whether a picture that was asked for has not been drawn yet.
    [[nodiscard]] bool waiting() const { return waiting_; }
    /// Forgets all requests for pictures; a picture that is requested again waits again.
    void forgetWaiting() { waiting_ = false; }

private:
    struct Picture {
        render::Size size;
        render::palette::Choice colours = render::palette::Choice::usual;
        std::uint64_t asked = 0;
        std::unique_ptr<render::Framebuffer> target; // nullptr: it cannot be drawn
    };
    void drawInto(render::Framebuffer const& target, CatalogEntry const& level);

    Registry const& registry_;
    PartLibrary const& parts_;
    render::Canvas& canvas_;
    decltype(CatalogMods::data) data_;
    std::map<std::string, Picture> pictures_; // by level id
    std::size_t mostKept_;
    std::uint64_t asked_ = 0; // counts requests
    std::optional<std::string> trouble_;
    bool mayDraw_ = true;
    bool waiting_ = false;
};

} // namespace trembler::ui
