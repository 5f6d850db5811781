#include "game/ui/shared/catalog/level_pictures.hpp"

#include "game/ui/shared/catalog/small_scene.hpp"
#include "puzzle/checks/checked_level.hpp"
#include "render/draw/palette.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/read/read_level.hpp"

#include <algorithm>
#include <exception>
#include <utility>

namespace trembler::ui {

using namespace render;

LevelPictures::LevelPictures(Registry const& registry, PartLibrary const& parts, Canvas& canvas,
                             decltype(CatalogMods::data) data, std::size_t mostKept)
    : registry_(registry), parts_(parts), canvas_(canvas), data_(std::move(data)),
      mostKept_(std::max<std::size_t>(mostKept, 1)) {}

void LevelPictures::drawInto(Framebuffer const& target, CatalogEntry const& level) {
    auto const data = data_ ? data_(level.file) : nullptr;
    Registry const& registry = data ? data->registry : registry_;
    LevelFile const file = loadLevel(registry, level.file);
    BuiltLevel const built = checkPlayable(registry, data ? data->parts : parts_, file);
    drawSmallScene(canvas_, target, *built.world);
}

unsigned LevelPictures::texture(CatalogEntry const& level, Size size) {
    if (!level.trouble.empty() || size.width <= 0 || size.height <= 0) {
        return 0;
    }
    Picture& picture = pictures_[level.id];
    picture.asked = ++asked_;
    if (pictures_.size() > mostKept_) {
        pictures_.erase(
            std::min_element(pictures_.begin(), pictures_.end(),
                             [](auto const& a, auto const& b) { return a.second.asked < b.second.asked; }));
    }
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
    } catch (InputError const& error) {
        trouble_ = troubleFrom(error);
        picture.target.reset();
    } catch (std::exception const&) { // it cannot be drawn here; it may be playable all the same
        picture.target.reset();
    }
    return picture.target == nullptr ? 0 : picture.target->texture();
}

} // namespace trembler::ui
