#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/tools/edit_mouse.hpp"
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace trembler::ui {
namespace {

using edit::Json;

constexpr double smallestFactor = 0.02;

/// The factors by which dragging a handle to a place scales a box, and the point that stays.
struct Scaling {
    Vec2 factors{1, 1};
    Vec2 centre;
};

double factorOf(double from, double to, double fixed) {
    double const before = from - fixed;
    return std::abs(before) < 1e-9 ? 1 : std::max((to - fixed) / before, smallestFactor);
}

Scaling scalingTo(SelectionHandles const& handles, std::size_t handle, Vec2 to) {
    Vec2 const from = handles.edges[handle];
    Vec2 const middle = handles.middle();
    Vec2 const fixed = 2 * middle - from; // the handle on the other side
    Scaling scaling{{1, 1}, fixed};
    if (handle < 4) { // both directions alike: no shape is distorted by a corner
        double const before = length(from - fixed);
        double const along =
            before > 0 ? ((to.x - fixed.x) * (from.x - fixed.x) + (to.y - fixed.y) * (from.y - fixed.y)) /
                             (before * before)
                       : 1;
        double const factor = std::max(along, smallestFactor);
        scaling.factors = {factor, factor};
    } else if (handle < 6) {
        scaling.factors.x = factorOf(from.x, to.x, fixed.x);
    } else {
        scaling.factors.y = factorOf(from.y, to.y, fixed.y);
    }
    return scaling;
}

} // namespace

void EditMouse::drag(EditParts& parts) {
    Pointer const& pointer = parts.pointer;
    bool const moved = pointer.strayed(pressedAt_) > dragThreshold;
    switch (doing_) {
    case Doing::pressing:
        if (!moved || edit::unlocked(before_, parts.selected()).empty()) {
            return;
        }
        doing_ = Doing::moving;
        [[fallthrough]];
    case Doing::moving: {
        Vec2 const by = snapped(parts, anchor_ + pointer.world - start_) - anchor_;
        return change(parts, [&](Json const& level) {
            return edit::moveObjects(*parts.data, level, parts.selected(), by);
        });
    }
    case Doing::turning: {
        Vec2 const centre = handles_->middle();
        Vec2 const arm = pointer.world - centre;
        double const angle = std::atan2(arm.y, arm.x) - std::numbers::pi / 2;
        double const degrees =
            (pointer.free || pointer.fine ? angle : parts.snapping.angle(angle)) * 180 / std::numbers::pi;
        return change(parts, [&](Json const& level) {
            return edit::rotateObjects(*parts.data, level, parts.selected(), degrees, centre);
        });
    }
    case Doing::scaling: {
        Vec2 const gap = handles_->scaling[handle_] - handles_->edges[handle_];
        Scaling const scaling = scalingTo(*handles_, handle_, snapped(parts, pointer.world - gap));
        return change(parts, [&](Json const& level) {
            return edit::scaleObjects(*parts.data, level, parts.selected(), scaling.factors, scaling.centre);
        });
    }
    case Doing::areaCorner:
    case Doing::areaMoving: {
        if (!moved) {
            return;
        }
        Area const area = doing_ == Doing::areaCorner
                              ? withCorner(area_.area, handle_, snapped(parts, pointer.world))
                              : movedArea(area_.area, parts.snapping.place(pointer.world - start_));
        return change(parts, [&](Json const& level) {
            return area_.kind == EntryKind::placing
                       ? edit::setPlacingArea(level, indexOfPath(area_.path), area)
                       : edit::setGoalArea(level, area_.path, area, parts.goalTree);
        });
    }
    case Doing::jointMoving:
        return change(parts, [&](Json const& level) {
            return edit::moveJointPoint(level, joint_.joint, joint_.field, snapped(parts, pointer.world));
        });
    default:
        return;
    }
}

void EditMouse::releaseDrawing(EditParts& parts) {
    Vec2 const to = snapped(parts, parts.pointer.world);
    Tool const tool = parts.tool;
    bool const area = tool == Tool::placing || tool == Tool::goalArea;
    if (parts.pointer.strayed(pressedAt_) <= dragThreshold) {
        if (area) { // the first corner of a polygon
            corners_.push_back(start_);
        }
        return; // a click draws nothing else
    }
    if (area) {
        Vec2 const low{std::min(start_.x, to.x), std::min(start_.y, to.y)};
        Vec2 const size{std::abs(start_.x - to.x), std::abs(start_.y - to.y)};
        if (size.x > 0 && size.y > 0) {
            actions::addArea(parts, tool, Area{Box{low, size}, {}});
        }
        return;
    }
    actions::addDrawn(parts, [&](Json const& level) {
        if (tool == Tool::box) {
            return actions::shapeCommand(level, edit::drawnBox(start_, to), "box");
        }
        if (tool == Tool::disc) {
            return actions::shapeCommand(level, edit::drawnDisc(start_, to), "disc");
        }
        return actions::shapeCommand(level, edit::drawnCapsule(start_, to, parts.capsuleRadius), "capsule");
    });
}

void EditMouse::releaseConnecting(EditParts& parts) {
    std::string const to = pickObject(parts, parts.pointer.world);
    bool const same = to == from_;
    if (parts.tool == Tool::wire) {
        if (!to.empty() && !same) {
            actions::connectObjects(parts, from_, to);
        }
        return;
    }
    bool const clicked = parts.pointer.strayed(pressedAt_) <= dragThreshold;
    // On the object itself, or on the paper: to the world.
    Vec2 const end = snapped(parts, parts.pointer.world);
    actions::joinObjects(parts, from_, same ? "" : to, clicked ? end : start_, end);
}

void EditMouse::release(EditParts& parts) {
    switch (std::exchange(doing_, Doing::nothing)) {
    case Doing::pressing: // a click without a drag
        parts.selection.set(edit::withGroups(parts.tree(), {clicked_}));
        parts.selection.choosePiece("");
        if (pressedTwice_) {
            parts.tab = Tab::properties;
            std::string const piece = pickPiece(parts, clicked_, parts.pointer.world);
            if (!piece.empty()) {
                parts.selection.set({clicked_}); // without its group
                parts.selection.choosePiece(piece);
            }
        }
        break;
    case Doing::boxing:
        if (parts.pointer.strayed(pressedAt_) <= dragThreshold) {
            if (!parts.context.shiftHeld()) {
                parts.selection.clear();
            }
            break;
        }
        if (!parts.context.shiftHeld()) {
            parts.selection.clear();
        }
        for (std::string const& name :
             edit::withGroups(parts.tree(), objectsWithin(parts, start_, parts.pointer.world))) {
            parts.selection.add(name);
        }
        break;
    case Doing::drawing:
        releaseDrawing(parts);
        break;
    case Doing::connecting:
        releaseConnecting(parts);
        break;
    default:
        break;
    }
    if (!refused_.empty()) {
        parts.tell(refused_, render::ToastKind::Trouble);
        refused_.clear();
    }
    gesture_ = {};
}

} // namespace trembler::ui
