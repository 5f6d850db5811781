#include "game/ui/edit/study/found_pictures.hpp"

#include "game/ui/shared/catalog/small_scene.hpp"
#include "render/draw/palette.hpp"
#include "render/gl/error.hpp"

namespace trembler::ui {

unsigned FoundPictures::texture(render::Canvas& canvas, std::size_t number, Session const& session,
                                render::Size size) {
    if (size.width <= 0 || size.height <= 0) {
        return 0;
    }
    Picture& picture = pictures_[number];
    if (picture.size != size || picture.colours != render::palette::inUse()) {
        picture.size = size;
        picture.colours = render::palette::inUse();
        try {
            picture.target = std::make_unique<render::Framebuffer>(size);
            drawSmallScene(canvas, *picture.target, session.world());
        } catch (render::RenderError const&) {
            picture.target.reset();
        }
    }
    return picture.target == nullptr ? 0 : picture.target->texture();
}

} // namespace trembler::ui
