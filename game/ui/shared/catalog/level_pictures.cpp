#include "game/ui/shared/catalog/level_pictures.hpp"

#include "puzzle/session/session.hpp"
#include "render/draw/palette.hpp"
#include "render/gl/error.hpp"
#include "render/scene/facts/pick.hpp"
#include "render/scene/scene_view.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/read/read_level.hpp"

#include <utility>

namespace trembler::ui {

using namespace render;

LevelPictures::LevelPictures(Registry const& registry, PartLibrary const& parts, Canvas& canvas,
                             decltype(CatalogMods::data) data)
    : registry_(registry), parts_(parts), canvas_(canvas), data_(std::move(data)) {}

void LevelPictures::drawInto(Framebuffer const& target, CatalogEntry const& level) {
    auto const data = data_ ? data_(level.file) : nullptr;
    Registry const& registry = data ? data->registry : registry_;
    Session const session(registry, data ? data->parts : parts_, loadLevel(registry, level.file));
    World const& world = session.world();
    Size const size = target.size();
    Camera camera{{}, 100, size};
    if (Extent const extent = sceneFocus(world); !extent.empty()) {
        camera.fit(extent.lower, extent.upper, 0.05 * size.height);
    }
    target.bind();
    clearBound(palette::paper);
    // Lines as thin as on a screen of which this is a small copy.
    canvas_.begin(camera, {.uiScale = static_cast<float>(size.height) / 360.F, .shadows = false});
    canvas_.paper();
    drawScene(canvas_, world, {});
    canvas_.end();
}

unsigned LevelPictures::texture(CatalogEntry const& level, Size size) {
    if (!level.trouble.empty() || size.width <= 0 || size.height <= 0) {
        return 0;
    }
    Picture& picture = pictures_[level.id];
    if (picture.size == size && picture.colours == palette::inUse()) {
        return picture.target == nullptr ? 0 : picture.target->texture();
    }
    if (!std::exchange(mayDraw_, false)) {
        waiting_ = true;
        return picture.target == nullptr ? 0 : picture.target->texture(); // of another size for now
    }
    picture.size = size;
    picture.colours = palette::inUse();
    try {
        picture.target = std::make_unique<Framebuffer>(size);
        drawInto(*picture.target, level);
    } catch (InputError const&) { // as is told when the level is opened
        picture.target.reset();
    } catch (RenderError const&) {
        picture.target.reset();
    }
    return picture.target == nullptr ? 0 : picture.target->texture();
}

} // namespace trembler::ui
