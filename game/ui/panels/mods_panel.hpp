// The mods' panel: each script with its box, its switch, its parameters, its messages and its usage.
#pragma once

#include "game/mods/live_mods.hpp"
#include "game/ui/shared/layout.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace trembler::ui {

class ModsPanel {
public:
    void setOpen(bool open) { open_ = open; }
    [[nodiscard]] bool open() const { return open_; }
    /// Call between Gui::beginFrame and endFrame. `top` and the maximum `height` are in pixels at UI scale 1.
    /// Changes that the player makes to a script take effect in the live mods at once.
    void draw(Layout& layout, Registry const& registry, LiveMods& liveMods, Session const& session, float top,
              float height);

private:
    void drawScript(Layout& layout, Registry const& registry, LiveMods& liveMods, std::size_t number,
                    ComponentStatus const& status);
    void drawParameters(Layout& layout, LiveMods& liveMods, std::size_t number);

    bool open_ = false;
    float content_ = 0;                           // pixels: the height of the contents drawn last
    std::map<std::string, LastingObject> chosen_; // by script: the object whose parameters are shown
};

} // namespace trembler::ui
