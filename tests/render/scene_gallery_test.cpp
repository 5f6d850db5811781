// Pictures for people of what is in the tree: every part, and every level before and after it was run.
#include "physics/dynamics/joint.hpp"
#include "render/scene/body.hpp"
#include "render/scene/scene_view.hpp"
#include "runtime/level/build_world.hpp"
#include "runtime/level/read_level.hpp"
#include "tests/render/scene_stage.hpp"

namespace trembler::render::test {
namespace {

std::filesystem::path const root = TREMBLER_SOURCE_DIR;

TEST(SceneGallery, everyPart) {
    PartLibrary const library = loadParts(everything(), root / "assets" / "parts");
    Size const size{1280, 720};
    Camera camera;
    camera.viewport = size;
    camera.fit({-0.2, -4.7}, {9.2, 0.6}, 0);
    std::size_t drawn = 0;
    Image const sheet = picture(
        size, palette::paper,
        [&](Canvas& canvas) {
            canvas.paper();
            for (PartDefinition const* part : library.all()) {
                Prototype const prototype = part->prototype();
                Point const at{0.6 + 1.15 * static_cast<double>(drawn % 8),
                               -1.25 * static_cast<double>(drawn / 8)};
                Extent const own = extentOf(prototype, {});
                ASSERT_FALSE(own.empty()) << part->name;
                drawObject(canvas, factsOf(prototype), {at - own.centre(), 0});
                ++drawn;
            }
        },
        {}, camera);
    writePng(sheet, pictureFolder() / "scene-parts.png");
    EXPECT_EQ(drawn, library.all().size());
}

void drawLevel(std::filesystem::path const& file) {
    PartLibrary const library = loadParts(everything(), root / "assets" / "parts");
    LevelFile const level = readLevel(everything(), JsonDocument::load(file));
    std::vector<Placement> const placements =
        level.solutions.empty() ? std::vector<Placement>{} : level.solutions.front().placements;
    auto const world = buildWorld(everything(), level, library, placements);
    Camera camera;
    camera.viewport = {1280, 720};
    Extent const focus = sceneFocus(*world);
    ASSERT_FALSE(focus.empty());
    camera.fit(focus.lower, focus.upper, 20);
    std::vector<Area> const placing = level.placing.value_or(std::vector<Area>{});
    auto const save = [&](std::string const& suffix, SceneOptions const& options) {
        Image const image = picture(
            camera.viewport, palette::paper,
            [&](Canvas& canvas) {
                canvas.paper();
                drawScene(canvas, *world, options);
            },
            {}, camera);
        writePng(image, pictureFolder() / ("scene-" + file.stem().string() + suffix + ".png"));
    };
    save("-start", {.placing = placing});
    for (int frame = 0; frame < 240; ++frame) {
        world->step();
    }
    save("-ran", {.time = world->time()});
    save("-overlays", {.time = world->time(),
                       .overlays = {.electricity = true, .forces = true, .contacts = true, .motion = true}});
    save("-field", {.time = world->time(), .overlays = {.forces = true, .fieldLines = true}});
}

TEST(SceneGallery, everyLevel) {
    for (auto const& entry : std::filesystem::recursive_directory_iterator(root / "levels")) {
        if (entry.path().extension() == ".json" && entry.path().filename().string().find("schema") ==
                                                       std::string::npos) {
            SCOPED_TRACE(entry.path().string());
            EXPECT_NO_THROW(drawLevel(entry.path()));
        }
    }
}

} // namespace
} // namespace trembler::render::test
