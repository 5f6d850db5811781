#include "game/ui/edit/tools/edit_mouse.hpp"

#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/commands/shapes.hpp"
#include "puzzle/edit/tree/tree_access.hpp"

#include <utility>

namespace trembler::ui {
namespace {

constexpr double knobReach = 12;  // pixels at UI scale 1
constexpr double cornerReach = 7; // pixels at UI scale 1: the knobs that scale are near

bool nearTo(EditParts const& parts, Vec2 place) {
    return length(parts.pointer.world - place) < knobReach * parts.pointer.pixel;
}

} // namespace

Vec2 EditMouse::snapped(EditParts const& parts, Vec2 at) const {
    return parts.pointer.free ? at : parts.snapping.place(at);
}

void EditMouse::beginGesture(EditParts& parts, Doing doing) {
    doing_ = doing;
    before_ = parts.tree();
    gesture_ = {parts.document.newGesture(), edit::Gesture::Next::replaces};
    stepsBefore_ = parts.document.done();
    refused_.clear();
}

void EditMouse::change(EditParts& parts, std::function<edit::Command(edit::Json const&)> const& make) {
    refused_.clear();
    try {
        edit::Command const command = make(before_);
        parts.document.run(command, gesture_);
    } catch (edit::CommandError const& error) {
        refused_ = shownError(error);
    }
}

bool EditMouse::cancel(EditParts& parts) {
    bool const something = doing_ != Doing::nothing || !corners_.empty();
    if (parts.document.done() > stepsBefore_ && doing_ != Doing::nothing && gesture_.number != 0) {
        parts.document.goTo(stepsBefore_);
    }
    doing_ = Doing::nothing;
    gesture_ = {};
    corners_.clear();
    refused_.clear();
    return join_.cancel() || something;
}

void EditMouse::look(EditParts& parts) {
    Pointer const& pointer = parts.pointer;
    if (pointer.wheel != 0 && !pointer.overCard) {
        parts.view.zoom(pointer.screen, pointer.wheel);
    }
    if (pointer.rightPressed) {
        rightOnPaper_ = !pointer.overCard;
    }
    bool const right = pointer.rightHeld && rightOnPaper_;
    if ((pointer.middleHeld && !pointer.overCard) || right) {
        parts.view.startPan();
    } else if (!pointer.middleHeld) {
        parts.view.stopPan();
    }
    parts.view.drag(pointer.moved);
    if (pointer.rightClicked && !pointer.overCard) { // lets go, as Esc does
        if (!corners_.empty()) {
            corners_.clear();
        } else if (join_.cancel()) {
            doing_ = Doing::nothing;
        } else if (!parts.partInHand.empty()) {
            parts.partInHand.clear();
        } else {
            parts.tool = Tool::select;
        }
    }
}

bool EditMouse::pressHandle(EditParts& parts) {
    if (parts.selection.kind() == EntryKind::placing || parts.selection.kind() == EntryKind::goalArea) {
        for (SceneArea const& area : sceneAreas(parts)) {
            std::vector<Vec2> const corners = areaCorners(area.area);
            for (std::size_t i = 0; area.selected && i < corners.size(); ++i) {
                if (nearTo(parts, corners[i])) {
                    area_ = area;
                    handle_ = i;
                    beginGesture(parts, Doing::areaCorner);
                    return true;
                }
            }
        }
    }
    if (parts.selection.kind() == EntryKind::joint) {
        for (JointPoint const& point : jointPoints(parts)) {
            if (point.joint == indexOfPath(parts.selection.path()) && nearTo(parts, point.at)) {
                joint_ = point;
                beginGesture(parts, Doing::jointMoving);
                return true;
            }
        }
    }
    std::vector<Vec2> const corners = shapeCorners(parts);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (length(parts.pointer.world - corners[i]) < cornerReach * parts.pointer.pixel) {
            handle_ = i;
            beginGesture(parts, Doing::shapeCorner);
            return true;
        }
    }
    handles_ = handlesOf(parts);
    if (!handles_) {
        return false;
    }
    if (nearTo(parts, handles_->turn)) {
        beginGesture(parts, Doing::turning);
        return true;
    }
    for (std::size_t i = 0; i < handles_->scaling.size(); ++i) {
        if (nearTo(parts, handles_->scaling[i])) {
            handle_ = i;
            beginGesture(parts, Doing::scaling);
            return true;
        }
    }
    return false;
}

/// A press that meets no object: joints, wires and areas, else a box begins.
void EditMouse::pressOther(EditParts& parts) {
    Vec2 const at = parts.pointer.world;
    if (auto const connection = pickConnection(parts, at)) {
        parts.selection.choose(EntryKind::connection, "/connections/" + std::to_string(*connection));
        return;
    }
    SceneArea const area = pickArea(parts, at);
    if (area.kind != EntryKind::none) {
        parts.selection.choose(area.kind, area.path);
        if (area.kind == EntryKind::goalArea) {
            parts.goalPlace = area.path;
            parts.goalChosen = true;
        }
        area_ = area;
        beginGesture(parts, Doing::areaMoving);
        return;
    }
    doing_ = Doing::boxing;
}

void EditMouse::pressSelect(EditParts& parts) {
    if (pressHandle(parts)) {
        return;
    }
    Vec2 const at = parts.pointer.world;
    if (auto const joint = pickJoint(parts, at)) {
        parts.selection.choose(EntryKind::joint, "/joints/" + std::to_string(*joint));
        return;
    }
    clicked_ = pickObject(parts, at);
    if (clicked_.empty()) {
        return pressOther(parts);
    }
    std::vector<std::string> const all = edit::withGroups(parts.tree(), {clicked_});
    if (parts.context.shiftHeld()) {
        bool const had = parts.selection.has(clicked_);
        for (std::string const& name : all) {
            if (had) {
                parts.selection.remove(name);
            } else {
                parts.selection.add(name);
            }
        }
        return;
    }
    if (!parts.selection.has(clicked_)) {
        parts.selection.set(all);
    }
    edit::Json const* const entry = edit::findObject(parts.tree(), clicked_);
    anchor_ = entry == nullptr ? at : edit::placeOf(*entry);
    beginGesture(parts, Doing::pressing);
}

void EditMouse::clickCorner(EditParts& parts) {
    Vec2 const at = snapped(parts, parts.pointer.world);
    bool const closes = corners_.size() >= 3 &&
                        (nearTo(parts, corners_.front()) || parts.pointer.twice || at == corners_.back());
    if (!closes) {
        if (corners_.empty() || corners_.back() != at) {
            corners_.push_back(at);
        }
        return;
    }
    std::vector<Vec2> const corners = std::exchange(corners_, {});
    if (parts.tool == Tool::placing || parts.tool == Tool::goalArea) {
        return actions::addArea(parts, parts.tool, Area{{}, corners});
    }
    actions::addDrawn(parts, [&](edit::Json const& level) {
        return actions::shapeCommand(level, edit::drawnPolygon(corners), "polygon");
    });
}

void EditMouse::press(EditParts& parts) {
    pressedAt_ = parts.pointer.screen;
    pressedTwice_ = parts.pointer.twice;
    gesture_ = {};
    stepsBefore_ = parts.document.done();
    if (!parts.partInHand.empty()) {
        actions::addPart(parts, parts.partInHand, snapped(parts, parts.pointer.world));
        if (!parts.context.shiftHeld()) {
            parts.partInHand.clear();
        }
        return;
    }
    start_ = parts.tool == Tool::select ? parts.pointer.world : snapped(parts, parts.pointer.world);
    switch (parts.tool) {
    case Tool::select:
        return pressSelect(parts);
    case Tool::polygon:
        return clickCorner(parts);
    case Tool::joint:
    case Tool::wire:
        doing_ = join_.press(parts) ? Doing::connecting : Doing::nothing;
        return;
    default:
        if (!corners_.empty()) { // an area, clicked corner by corner
            return clickCorner(parts);
        }
        doing_ = Doing::drawing;
    }
}

void EditMouse::update(EditParts& parts) {
    Pointer const& pointer = parts.pointer;
    hovered_ = pointer.overCard || !pointer.inside ? "" : pickObject(parts, pointer.world);
    if (std::exchange(tool_, parts.tool) != parts.tool) { // what was begun with another one is given up
        cancel(parts);
    }
    join_.look(parts);
    bool const writable = !parts.document.readOnly();
    if (pointer.pressed && !pointer.overCard && !tookPart_) {
        parts.panelKeys = false;
        if (writable || parts.tool == Tool::select) {
            press(parts);
        }
    } else if (doing_ != Doing::nothing && pointer.held) {
        drag(parts);
    }
    if (pointer.released) {
        // A part that was dragged out of the catalogue is put down where the button is let go.
        if (!parts.partInHand.empty() && doing_ == Doing::nothing && !pointer.overCard && !pointer.pressed &&
            !tookPart_ && draggingPart_) {
            actions::addPart(parts, parts.partInHand, snapped(parts, pointer.world));
            parts.partInHand.clear();
        }
        release(parts);
        draggingPart_ = false;
    }
    if (tookPart_) {
        draggingPart_ = true;
        tookPart_ = false;
    }
    look(parts);
}

} // namespace trembler::ui
