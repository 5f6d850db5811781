#include "game/ui/headless/screenshot.hpp"

#include "game/ui/cards/play_cards.hpp"
#include "game/ui/headless/scene_painter.hpp"
#include "game/ui/play/view/goal_areas.hpp"
#include "game/ui/play/view/sound_view.hpp"
#include "game/ui/shared/camera_control.hpp"
#include "game/ui/shared/scene_words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/gui.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::ui {

using namespace render;

Image pictureOf(Window& window, Session const& session, PictureOptions const& options) {
    Gui gui(window, {.steady = true});
    InputEvents const input(window); // there are no events
    Canvas canvas;
    Layout layout;
    World const& world = session.world();
    auto const scale = static_cast<double>(window.uiScale());
    bool const goals = options.card && !session.level().title.empty();
    CameraControl view;
    GoalAreas areas(session.level());
    view.setSubject(pictureSubject(session, areas));
    double const left = goals ? scale * (goalCardWidth + 2 * static_cast<double>(cardGap)) : scale * cardGap;
    double const rest = scale * static_cast<double>(cardGap);
    view.setView(window.size(), {left, rest, rest, rest});
    Image image;
    SceneView const scene;
    // ImGui knows the size of a card only after a first layout pass: only the last pass is drawn.
    constexpr int passes = 3;
    for (int pass = 1; pass <= passes; ++pass) {
        if (options.step) {
            options.step(fmt::format("drawing, {} of {}", pass, passes));
        }
        gui.beginFrame(input, 1.0 / 60);
        layout.beginFrame();
        if (goals) {
            drawGoalCard(layout, session, {}, nullptr);
        }
        if (pass < passes) {
            gui.dropFrame();
            continue;
        }
        window.beginFrame(palette::paper);
        canvas.begin(view.camera(),
                     {.uiScale = window.uiScale(), .time = world.time(), .shadows = options.shadows});
        canvas.paper();
        scene.draw(canvas, world,
                   {.time = world.time(),
                    .overlays = options.overlays,
                    .goals = areas.regions(session.judge().status()),
                    .ripples = options.ripples});
        canvas.end();
        drawSceneWords(view.camera(), world, scene, 1, options.names);
        areas.drawWords(view.camera());
        gui.endFrame();
        image = window.readPixels();
        window.present();
    }
    return image;
}

Image screenshot(Session& session, ScreenshotOptions const& options) {
    SoundView sounds;
    for (std::uint64_t done = 0; done < options.frame; ++done) {
        sounds.beforeStep(session.world());
        session.step();
        sounds.afterStep(session.world());
        if (options.progress) {
            options.progress(done + 1);
        }
    }
    Window window({.size = options.size, .mode = WindowMode::Offscreen});
    PictureOptions picture = options.picture;
    picture.ripples = sounds.ripples();
    return pictureOf(window, session, picture);
}

} // namespace trembler::ui
