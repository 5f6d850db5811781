#include "game/ui/headless/scene_painter.hpp"

#include "game/ui/play/view/level_extents.hpp"
#include "game/ui/shared/card_sizes.hpp"
#include "game/ui/shared/scene_words.hpp"
#include "render/draw/palette.hpp"

namespace trembler::ui {

using namespace render;

Extent pictureSubject(Session const& session, GoalAreas const& areas) {
    Extent subject = focusOf(session);
    subject.add(areas.extent());
    return subject.empty() ? subject : subject.widened(0.05 * length(subject.half()));
}

ScenePainter::ScenePainter(Window& window, Session const& session)
    : window_(window), gui_(window, {.steady = true}), input_(window), areas_(session.level()) {
    view_.setSubject(pictureSubject(session, areas_));
    double const gap = static_cast<double>(window.uiScale()) * static_cast<double>(cardGap);
    view_.setView(window.size(), {gap, gap, gap, gap});
}

Image ScenePainter::draw(Session const& session, PictureOptions const& options,
                         std::vector<SparkView::Spark> const& sparks) {
    World const& world = session.world();
    gui_.beginFrame(input_, 1.0 / 60);
    window_.beginFrame(palette::paper);
    canvas_.begin(view_.camera(),
                  {.uiScale = window_.uiScale(), .time = world.time(), .shadows = options.shadows});
    canvas_.paper();
    scene_.draw(canvas_, world,
                {.time = world.time(), .overlays = options.overlays, .ripples = options.ripples});
    canvas_.newSheet();
    drawSparks(canvas_, sparks);
    canvas_.end();
    drawSceneWords(view_.camera(), world, scene_, 1, options.names);
    gui_.endFrame();
    Image image = window_.readPixels();
    window_.present();
    return image;
}

} // namespace trembler::ui
