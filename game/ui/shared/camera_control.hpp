// The player's view of the world: zoom at the mouse, pan, show everything.
#pragma once

#include "game/ui/shared/pointer.hpp"
#include "render/draw/camera.hpp"
#include "render/scene/facts/shape_geometry.hpp"

#include <optional>

namespace trembler::ui {

/// Pixels of the window that cards cover at each side.
struct Margins {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
};

/// A value type without access to the window; any thread.
class CameraControl {
public:
    /// The area that is shown by fit().
    void setSubject(render::Extent const& subject) { subject_ = subject; }
    /// Where panning and zooming end: the middle of the view between the margins stays in this area. Empty:
    /// nowhere.
    void setLimits(render::Extent const& limits) { limits_ = limits; }
    /// Follows the window's size; until the player moves the view, or hold() is called, it keeps showing
    /// everything.
    void setView(render::Size viewport, Margins const& margins);
    /// A view that shows the whole subject larger than the margins allow; nothing: there is none. It counts
    /// as long as the window has its size.
    void setPreferred(std::optional<render::Camera> const& preferred);
    /// The largest scale at which the subject fits between the margins, pixels per metre.
    [[nodiscard]] double scaleBetweenMargins() const;
    /// Shows the whole subject between the margins, or as preferred.
    void fit();
    /// Keeps the view when the window or the subject changes, as if the player had moved the view.
    void stay() { moved_ = true; }
    /// Keeps the view as it is until the window has another size, whatever else changes.
    void hold() { held_ = true; }
    /// Follows margins and subject again.
    void release() { held_ = false; }
    void zoom(render::Point at, double notches);
    /// Moves the view by shares of the window: {0.1, 0} looks a tenth of its width further to the right, y is
    /// up.
    void look(render::Point shares);
    /// The middle of the window inside the margins, pixels.
    [[nodiscard]] render::Point middle() const;
    void startPan() { panning_ = true; }
    void stopPan() { panning_ = false; }
    /// Pans with the mouse while the button is held.
    void drag(render::Point pixels);

    [[nodiscard]] render::Camera const& camera() const { return camera_; }

private:
    [[nodiscard]] double fittingScale() const;
    [[nodiscard]] render::Point looksAt() const { return camera_.toWorld(middle()); }
    /// Moves the view back if it looks at `before`, or at a place in the limits, no longer.
    void keepInLimits(render::Point before);

    render::Camera camera_;
    render::Extent subject_;
    render::Extent limits_;
    Margins margins_;
    std::optional<render::Camera> preferred_;
    bool panning_ = false;
    bool moved_ = false;
    bool held_ = false;
};

} // namespace trembler::ui
