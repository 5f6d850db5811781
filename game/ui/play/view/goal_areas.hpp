// The areas that a level's goals name, for drawing them into the world.
#pragma once

#include "game/ui/shared/layout.hpp"
#include "puzzle/goals/goal_judge.hpp"
#include "render/draw/camera.hpp"
#include "render/scene/areas.hpp"

#include <span>
#include <string>
#include <vector>

namespace trembler::ui {

/// Plain data of one level.
class GoalAreas {
public:
    explicit GoalAreas(LevelFile const& level);

    /// The areas, marked as reached where their goal is met. Valid until the next call.
    [[nodiscard]] std::span<render::GoalRegion const> regions(std::span<GoalStatus const> status);
    /// The smallest rectangle around all of them; empty if there are none.
    [[nodiscard]] render::Extent extent() const;
    /// Remembers where the world's objects are: names are written beside them. To be called for each new
    /// world, and not in a run, in which a name would jump whenever something passes it.
    void lookAt(World const& world);
    /// Writes the name of each area near one of its edges, where it covers the least of objects, lies in the
    /// view and is under none of the cards; between Gui::beginFrame and Gui::endFrame.
    void drawWords(render::Camera const& camera, std::span<Placed const> cards = {}) const;

private:
    void gather(Condition const& condition, std::size_t goal);
    [[nodiscard]] bool isKnown(Area const& area, std::size_t goal) const;

    std::vector<render::GoalRegion> regions_;
    std::vector<render::Extent> objects_; // of lookAt()
    std::vector<std::size_t> goals_;      // for each region, the number of its goal
    std::vector<std::string> names_;      // for each region; empty: none is written
};

} // namespace trembler::ui
