// The engineers' panel: every component of the world, what it costs, and the knobs.
#pragma once

#include "game/session/session.hpp"
#include "game/ui/layout.hpp"
#include "render/panels/toasts.hpp"

#include <map>
#include <string>
#include <vector>

namespace trembler::ui {

/// An effect that can be computed in more than one way.
struct EffectLevels {
    std::string effect;
    std::vector<std::string> levels; ///< by rising cost
    std::string chosen;              ///< stated for this session; "" leaves it to the scene
    std::string working;             ///< the level of the component that is at work; "" if none is
};

/// Effects with more than one level, in order of their names.
[[nodiscard]] std::vector<EffectLevels> effectLevels(World const& world);

class ComponentsPanel {
public:
    void toggle() { open_ = !open_; }
    [[nodiscard]] bool open() const { return open_; }
    /// Between Gui::beginFrame and endFrame, in pixels at UI scale 1: where its top is and how high it may
    /// be.
    void draw(Layout& layout, Session& session, render::Toasts& toasts, float top, float height);

private:
    void drawLevels(Layout& layout, Session& session, render::Toasts& toasts);
    void drawTable(Layout& layout, Session& session, render::Toasts& toasts);
    void drawRow(Layout& layout, ComponentStatus const& status, double slowest, Session& session,
                 render::Toasts& toasts);

    bool open_ = false;
    bool all_ = false;                     // absent ones too
    std::map<std::string, double> smooth_; // µs by title, so that the bars can be read
};

} // namespace trembler::ui
