#include "game/ui/play/view/goal_areas.hpp"

#include "game/ui/play/view/area_name_place.hpp"
#include "game/ui/shared/texts.hpp"
#include "puzzle/goals/read_goals.hpp"
#include "render/panels/world_label.hpp"
#include "render/scene/facts/pick.hpp"

namespace trembler::ui {

GoalAreas::GoalAreas(LevelFile const& level) {
    auto const condition = readGoals(level);
    if (!condition) {
        return;
    }
    std::span<Condition const> const goals = goalsOf(*condition);
    for (std::size_t i = 0; i < goals.size(); ++i) {
        gather(goals[i], i);
    }
}

// A sequence may name an area more than once.
bool GoalAreas::isKnown(Area const& area, std::size_t goal) const {
    for (std::size_t i = 0; i < regions_.size(); ++i) {
        if (goals_[i] == goal && regions_[i].area == area) {
            return true;
        }
    }
    return false;
}

void GoalAreas::gather(Condition const& condition, std::size_t goal) {
    if (condition.area && !isKnown(*condition.area, goal)) {
        regions_.push_back({*condition.area, false});
        goals_.push_back(goal);
        // Sentences say "the marked area"; in the world the mark itself shows it.
        names_.push_back(condition.areaName == Condition{}.areaName ? "" : condition.areaName);
    }
    for (Condition const& child : condition.children) {
        gather(child, goal);
    }
}

std::span<render::GoalRegion const> GoalAreas::regions(std::span<GoalStatus const> status) {
    for (std::size_t i = 0; i < regions_.size(); ++i) {
        regions_[i].met = goals_[i] < status.size() && status[goals_[i]].met;
    }
    return regions_;
}

render::Extent GoalAreas::extent() const {
    render::Extent all;
    for (render::GoalRegion const& region : regions_) {
        all.add(render::extentOf(region.area));
    }
    return all;
}

void GoalAreas::lookAt(World const& world) {
    objects_ = render::extentsOf(world);
}

void GoalAreas::drawWords(render::Camera const& camera, std::span<Placed const> cards) const {
    for (std::size_t i = 0; i < regions_.size(); ++i) {
        if (names_[i].empty()) {
            continue;
        }
        std::string const& name = shownArea(names_[i]);
        render::Point const at = areaNamePlace(camera, render::extentOf(regions_[i].area),
                                               render::chipSize(name.c_str()), objects_, cards);
        render::worldLabel(camera, at, name.c_str(),
                           {.colour = regions_[i].met ? render::palette::goal : render::palette::inkSoft});
    }
}

} // namespace trembler::ui
