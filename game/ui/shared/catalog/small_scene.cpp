#include "game/ui/shared/catalog/small_scene.hpp"

#include "render/draw/palette.hpp"
#include "render/scene/facts/pick.hpp"
#include "render/scene/scene_view.hpp"

namespace trembler::ui {

using namespace render;

void drawSmallScene(Canvas& canvas, Framebuffer const& target, World const& world) {
    Size const size = target.size();
    Camera camera{{}, 100, size};
    if (Extent const extent = sceneFocus(world); !extent.empty()) {
        camera.fit(extent.lower, extent.upper, 0.05 * size.height);
    }
    target.bind();
    clearBound(palette::paper);
    // Lines as thin as on a screen of which this is a small copy.
    canvas.begin(camera, {.uiScale = static_cast<float>(size.height) / 360.F, .shadows = false});
    canvas.paper();
    drawScene(canvas, world, {});
    canvas.end();
}

} // namespace trembler::ui
