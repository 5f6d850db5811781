// The engineers' panel: every component of the world, its cost, and the knobs.
#pragma once

#include "game/ui/panels/cost_rows.hpp"
#include "render/panels/toasts.hpp"

#include <map>
#include <string>
#include <vector>

namespace trembler::ui {

class ComponentsPanel {
public:
    void toggle() { open_ = !open_; }
    [[nodiscard]] bool open() const { return open_; }
    /// See CostRows.
    void setTips(CostRows::Tips tips) { costs_.setTips(std::move(tips)); }
    /// Call between Gui::beginFrame and endFrame. `top` and the maximum `height` are in pixels at UI scale 1.
    void draw(Layout& layout, Session& session, budget::BudgetMode& mode, render::Toasts& toasts, float top,
              float height);

private:
    void drawTable(Layout& layout, Session& session, render::Toasts& toasts);
    void drawRow(Layout& layout, ComponentStatus const& status, double slowest, Session& session,
                 render::Toasts& toasts);

    CostRows costs_;
    bool open_ = false;
    bool all_ = false;                     // also lists absent components
    std::map<std::string, double> smooth_; // µs by title, smoothed so that the bars are legible
};

} // namespace trembler::ui
