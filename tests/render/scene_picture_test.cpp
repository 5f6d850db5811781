#include "render/scene/scene_view.hpp"
#include "tests/render/scene_stage.hpp"

namespace trembler::render::test {
namespace {

Image draw(World const& world, SceneOptions const& options = {}) {
    Size const size{1280, 720};
    return picture(
        size, palette::paper,
        [&](Canvas& canvas) {
            canvas.paper();
            drawScene(canvas, world, options);
        },
        {}, stageCamera(size));
}

TEST(ScenePicture, experimentForPeople) {
    ExperimentStage stage;
    writePng(draw(stage.world), pictureFolder() / "scene-rest.png");
    stage.closeSwitch();
    writePng(draw(stage.world, {.time = 0.3}), pictureFolder() / "scene-on.png");
}

} // namespace
} // namespace trembler::render::test
