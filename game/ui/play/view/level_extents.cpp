#include "game/ui/play/view/level_extents.hpp"

#include "render/scene/areas.hpp"
#include "render/scene/facts/pick.hpp"

#include <algorithm>

namespace trembler::ui {

Rect onScreen(render::Camera const& camera, render::Extent const& extent) {
    return {camera.toScreen({extent.lower.x, extent.upper.y}),
            camera.toScreen({extent.upper.x, extent.lower.y})};
}

render::Extent focusOf(Session const& session) {
    render::Extent bounds;
    if (auto const& box = session.level().bounds) {
        bounds = render::extentOf(Area{.box = box, .corners = {}});
    }
    return render::sceneFocus(session.world(), bounds);
}

LevelExtents levelExtents(Session const& session, GoalAreas const& goals, PartCatalog& catalog) {
    constexpr double gap = 0.06;   // m, around each
    constexpr double handle = 0.7; // m, from a part's edge to beyond its handle, if the level is small
    render::Extent const focus = focusOf(session);
    LevelExtents all;
    for (render::Extent const& own : render::extentsOf(session.world())) {
        if (!own.overlaps(focus)) {
            continue;
        }
        render::Extent seen; // of a floor without end only the part that matters
        for (render::Point const corner : {own.lower, own.upper}) {
            seen.add(render::Point{std::clamp(corner.x, focus.lower.x, focus.upper.x),
                                   std::clamp(corner.y, focus.lower.y, focus.upper.y)});
        }
        all.seen.push_back(seen.widened(gap));
    }
    if (render::Extent const goal = goals.extent(); !goal.empty()) {
        all.seen.push_back(goal.widened(gap));
    }
    auto const addAround = [&](std::string const& part, Vec2 at) {
        render::Extent own;
        own.add(render::Point{at.x, at.y});
        all.around.push_back(own.widened(catalog.radius(part) + handle));
    };
    for (PlacedPart const& part : session.placed()) {
        addAround(part.placement.part, part.placement.at);
    }
    for (TeachingStep const& step : session.level().teaching) {
        if (step.kind == TeachingStep::Kind::place) {
            addAround(step.object, step.at);
        }
    }
    if (session.level().placing) {
        for (Area const& area : *session.level().placing) {
            all.places.push_back(render::extentOf(area).widened(gap));
        }
    }
    return all;
}

} // namespace trembler::ui
