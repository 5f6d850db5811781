#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/tools/edit_mouse.hpp"
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/shapes.hpp"
#include "puzzle/edit/tree/grid_features.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// The factor nearest to `factor` that takes an edge of the box, across or up, to the grid.
double factorOnGrid(Snapping const& snapping, Vec2 from, Vec2 fixed, double factor) {
    double best = factor;
    double least = std::numeric_limits<double>::infinity();
    auto const consider = [&](double edge, double other) {
        double const snapped = factorOf(edge, snapping.along(other + factor * (edge - other)), other);
        if (std::abs(edge - other) > 1e-9 && std::abs(snapped - factor) < least) {
            least = std::abs(snapped - factor);
            best = snapped;
        }
    };
    consider(from.x, fixed.x);
    consider(from.y, fixed.y);
    return best;
}

/// `snapping`: nullptr for none. `evenly`: a corner keeps the proportions.
Scaling scalingTo(SelectionHandles const& handles, std::size_t handle, Vec2 to, Snapping const* snapping,
                  bool evenly) {
    Vec2 const from = handles.edges[handle];
    Vec2 const middle = handles.middle();
    Vec2 const fixed = 2 * middle - from; // the handle on the other side
    Scaling scaling{{1, 1}, fixed};
    Vec2 const end = snapping == nullptr ? to : snapping->place(to);
    if (handle < 4 && !evenly) {
        scaling.factors = {factorOf(from.x, end.x, fixed.x), factorOf(from.y, end.y, fixed.y)};
    } else if (handle < 4) {
        double const before = length(from - fixed);
        double const along =
            before > 0 ? ((to.x - fixed.x) * (from.x - fixed.x) + (to.y - fixed.y) * (from.y - fixed.y)) /
                             (before * before)
                       : 1;
        double const raw = std::max(along, smallestFactor);
        double const factor = snapping == nullptr ? raw : factorOnGrid(*snapping, from, fixed, raw);
        scaling.factors = {factor, factor};
    } else if (handle < 6) {
        scaling.factors.x = factorOf(from.x, end.x, fixed.x);
    } else {
        scaling.factors.y = factorOf(from.y, end.y, fixed.y);
    }
    return scaling;
}

} // namespace

Vec2 EditMouse::wayOnGrid(EditParts const& parts, Vec2 way) const {
    if (parts.pointer.free || !parts.snapping.on) {
        return way;
    }
    double const step = parts.snapping.grid;
    return {edit::wayOnGrid(features_.x, way.x, step), edit::wayOnGrid(features_.y, way.y, step)};
}

void EditMouse::drag(EditParts& parts) {
    Pointer const& pointer = parts.pointer;
    bool const moved = pointer.strayed(pressedAt_) > dragThreshold;
    switch (doing_) {
    case Doing::pressing:
        if (!moved || edit::unlocked(before_, parts.selected()).empty()) {
            return;
        }
        doing_ = Doing::moving;
        features_ = edit::gridFeatures(*parts.data, before_, edit::unlocked(before_, parts.selected()));
        [[fallthrough]];
    case Doing::moving: {
        moved_ = wayOnGrid(parts, pointer.world - start_);
        return change(parts, [&](Json const& level) {
            return edit::moveObjects(*parts.data, level, parts.selected(), moved_);
        });
    }
    case Doing::turning: {
        Vec2 const centre = handles_->middle();
        Vec2 const arm = pointer.world - centre;
        double const angle = std::atan2(arm.y, arm.x) - std::numbers::pi / 2;
        double const degrees =
            (pointer.free || pointer.fine ? angle : parts.snapping.angle(angle)) * 180 / std::numbers::pi;
        return change(parts, [&](Json const& level) {
            return pointer.free ? edit::rotateObjects(*parts.data, level, parts.selected(), degrees, centre)
                                : actions::rotation(parts, level, degrees, centre);
        });
    }
    case Doing::scaling: {
        Vec2 const gap = handles_->scaling[handle_] - handles_->edges[handle_];
        bool const grid = parts.snapping.on && !pointer.free;
        // Discs, and what is turned, can be scaled in both directions alike only.
        bool const evenly = pointer.fine || !handles_->stretches();
        Scaling const scaling =
            scalingTo(*handles_, handle_, pointer.world - gap, grid ? &parts.snapping : nullptr, evenly);
        return change(parts, [&](Json const& level) {
            return edit::scaleObjects(*parts.data, level, parts.selected(), scaling.factors, scaling.centre);
        });
    }
    case Doing::shapeCorner:
        if (!moved) {
            return;
        }
        return change(parts, [&](Json const& level) {
            return edit::moveCorner(*parts.data, level, parts.selected().front(), handle_,
                                    snapped(parts, pointer.world));
        });
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
        join_.release(parts);
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
