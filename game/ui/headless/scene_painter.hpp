// Draws one scene again and again without any interface, for moving pictures.
#pragma once

#include "game/ui/headless/screenshot.hpp"
#include "game/ui/play/view/goal_areas.hpp"
#include "game/ui/play/view/spark_view.hpp"
#include "game/ui/shared/camera_control.hpp"
#include "render/panels/gui.hpp"

namespace trembler::ui {

/// The content of a picture of a level: its scene, the areas of its goals, and a margin.
[[nodiscard]] render::Extent pictureSubject(Session const& session, GoalAreas const& areas);

/// The camera stays where it was at the beginning. Window thread only; the window must outlive it.
class ScenePainter {
public:
    /// Shows the whole scene as it is now. Throws render::RenderError.
    ScenePainter(render::Window& window, Session const& session);
    /// The card of `options` is not drawn. Throws render::RenderError.
    [[nodiscard]] render::Image draw(Session const& session, PictureOptions const& options,
                                     std::vector<SparkView::Spark> const& sparks);

private:
    render::Window& window_;
    render::Gui gui_;
    render::InputEvents input_; // there are no events
    render::Canvas canvas_;
    render::SceneView scene_;
    GoalAreas areas_;
    CameraControl view_;
};

} // namespace trembler::ui
