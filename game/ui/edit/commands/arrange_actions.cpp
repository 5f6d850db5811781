#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/view/edit_geometry.hpp"
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/commands/rotate_on_grid.hpp"
#include "puzzle/edit/tree/extent.hpp"

#include <utility>

namespace trembler::ui::actions {
namespace {

using edit::Json;

constexpr double fineStep = 0.001; // m
constexpr double plainStep = 0.05; // m, without a grid

Vec2 middleOfSelection(EditParts const& parts) {
    auto const box = edit::extentOfObjects(*parts.data, parts.tree(), parts.selected());
    return box ? box->corner + 0.5 * box->size : Vec2{};
}

edit::Alignment modelAlignment(Alignment alignment) {
    switch (alignment) {
    case Alignment::left:
        return edit::Alignment::left;
    case Alignment::right:
        return edit::Alignment::right;
    case Alignment::top:
        return edit::Alignment::top;
    case Alignment::bottom:
        return edit::Alignment::bottom;
    case Alignment::column:
        return edit::Alignment::centresX;
    case Alignment::row:
        break;
    }
    return edit::Alignment::centresY;
}

/// Moves a selected joint, with all its points, or a selected area.
edit::Command moveOtherThing(EditParts const& parts, Json const& level, Vec2 by) {
    std::string const path = parts.selection.path();
    if (parts.selection.kind() == EntryKind::joint) {
        std::vector<edit::Command> all;
        for (JointPoint const& point : jointPoints(parts)) {
            if (point.joint == indexOfPath(path)) {
                all.push_back(edit::moveJointPoint(level, point.joint, point.field, point.at + by));
            }
        }
        std::string const name = all.empty() ? std::string() : all.front().name;
        return edit::together(name, std::move(all));
    }
    for (SceneArea const& area : sceneAreas(parts)) {
        if (area.selected) {
            return area.kind == EntryKind::placing
                       ? edit::setPlacingArea(level, indexOfPath(path), movedArea(area.area, by))
                       : edit::setGoalArea(level, path, movedArea(area.area, by), parts.goalTree);
        }
    }
    throw edit::CommandError("nothing is selected that can be moved");
}

/// The names of all objects for which a test holds.
template <class Test>
std::vector<std::string> namesWhere(EditParts const& parts, Test&& test) {
    std::vector<std::string> names;
    for (std::string const& name : edit::objectNames(parts.tree())) {
        if (test(name)) {
            names.push_back(name);
        }
    }
    return names;
}

} // namespace

bool canScale(EditParts const& parts) {
    return !parts.selected().empty() &&
           edit::mayScale(*parts.data, parts.tree(), parts.selected(), {1.1, 1.1});
}

bool canMove(EditParts const& parts) {
    EntryKind const kind = parts.selection.kind();
    return !parts.selected().empty() || kind == EntryKind::joint || kind == EntryKind::placing ||
           kind == EntryKind::goalArea;
}

void move(EditParts& parts, Vec2 steps) {
    double const step =
        parts.context.shiftHeld() ? fineStep : (parts.snapping.on ? parts.snapping.grid : plainStep);
    parts.run([&](Json const& level) {
        return parts.selected().empty()
                   ? moveOtherThing(parts, level, step * steps)
                   : edit::moveObjects(*parts.data, level, parts.selected(), step * steps);
    });
}

void rotate(EditParts& parts, int steps) {
    double const degrees =
        parts.context.shiftHeld() ? 1 : (parts.snapping.on ? parts.snapping.angleDegrees : 15);
    Vec2 const centre = middleOfSelection(parts);
    parts.run([&](Json const& level) { return rotation(parts, level, steps * degrees, centre); });
}

edit::Command rotation(EditParts const& parts, Json const& level, double degrees, Vec2 centre) {
    return parts.snapping.on ? edit::rotateOnGrid(*parts.data, level, parts.selected(), degrees, centre,
                                                  parts.snapping.grid)
                             : edit::rotateObjects(*parts.data, level, parts.selected(), degrees, centre);
}

void resize(EditParts& parts, double factor) {
    Vec2 const centre = middleOfSelection(parts);
    parts.run([&](Json const& level) {
        return edit::scaleObjects(*parts.data, level, parts.selected(), {factor, factor}, centre);
    });
}

void mirrorAcross(EditParts& parts) {
    Vec2 const centre = middleOfSelection(parts);
    parts.run([&](Json const& level) {
        return edit::mirrorObjects(*parts.data, level, parts.selected(), edit::Mirror::leftRight, centre);
    });
}

void mirrorDown(EditParts& parts) {
    Vec2 const centre = middleOfSelection(parts);
    parts.run([&](Json const& level) {
        return edit::mirrorObjects(*parts.data, level, parts.selected(), edit::Mirror::upDown, centre);
    });
}

void alignTo(EditParts& parts, Alignment alignment) {
    parts.run([&](Json const& level) {
        return edit::alignObjects(*parts.data, level, parts.selected(), modelAlignment(alignment));
    });
}

void distributeAlong(EditParts& parts, bool sideways) {
    parts.run([&](Json const& level) {
        return edit::distributeObjects(*parts.data, level, parts.selected(),
                                       sideways ? edit::Axis::x : edit::Axis::y);
    });
}

void group(EditParts& parts) {
    parts.run([&](Json const& level) { return edit::groupObjects(level, parts.selected()); });
}

void ungroup(EditParts& parts) {
    parts.run([&](Json const& level) { return edit::ungroupObjects(level, parts.selected()); });
}

void lock(EditParts& parts) {
    parts.run([&](Json const& level) { return edit::lockObjects(level, parts.selected(), true); });
}

void unlockAll(EditParts& parts) {
    auto const names =
        namesWhere(parts, [&](std::string const& name) { return edit::isLocked(parts.tree(), name); });
    if (!names.empty()) {
        parts.run([&](Json const& level) { return edit::lockObjects(level, names, false); });
    }
}

void hide(EditParts& parts) {
    if (parts.run([&](Json const& level) { return edit::hideObjects(level, parts.selected(), true); })) {
        parts.selection.clear();
    }
}

void showAll(EditParts& parts) {
    auto const names =
        namesWhere(parts, [&](std::string const& name) { return edit::isHidden(parts.tree(), name); });
    if (!names.empty()) {
        parts.run([&](Json const& level) { return edit::hideObjects(level, names, false); });
    }
}

void frameAll(EditParts& parts) {
    parts.view.setSubject(parts.extent());
    parts.view.fit();
}

void frameSelection(EditParts& parts) {
    auto const box = edit::extentOfObjects(*parts.data, parts.tree(), parts.selected());
    if (!box) {
        return frameAll(parts);
    }
    render::Extent all;
    all.add(render::toPoint(box->corner));
    all.add(render::toPoint(box->corner + box->size));
    parts.view.setSubject(all.widened(0.3 + 0.5 * render::length(all.half())));
    parts.view.fit();
    parts.view.stay();
    parts.view.setSubject(parts.extent()); // for the limits of the zoom
}

void zoomBy(EditParts& parts, int notches) {
    render::Size const size = parts.camera().viewport;
    parts.view.zoom({0.4 * size.width, 0.5 * size.height}, 2 * notches);
}

void lookBy(EditParts& parts, int right, int up) {
    parts.view.look({0.1 * right, 0.1 * up});
}

} // namespace trembler::ui::actions
