#include "game/ui/edit/tools/join_tool.hpp"

#include "game/ui/edit/commands/edit_actions.hpp"

#include <utility>

namespace trembler::ui {
namespace {

bool joins(Tool tool) {
    return tool == Tool::wire || tool == Tool::joint;
}

Vec2 placeOnGrid(EditParts const& parts) {
    Pointer const& pointer = parts.pointer;
    return pointer.free ? pointer.world : parts.snapping.place(pointer.world);
}

} // namespace

bool JoinTool::isClick(EditParts const& parts) const {
    return parts.pointer.strayed(pressedAt_) <= dragThreshold;
}

Join JoinTool::joinTo(EditParts const& parts, JoinEnd const& to) const {
    Vec2 const end = placeOnGrid(parts);
    // On the object itself: to the world.
    JoinEnd const other = to.object == from_.object ? JoinEnd{} : to;
    return {parts.tool, from_, other, isClick(parts) ? end : start_, end};
}

void JoinTool::look(EditParts const& parts) {
    if (!joins(parts.tool)) {
        cancel();
        under_ = {};
        why_.clear();
        return;
    }
    if (!from_.name.empty()) { // the world may have been built again, without it
        from_ = endNamed(parts, from_.name);
    }
    Pointer const& pointer = parts.pointer;
    under_ = pointer.overCard || !pointer.inside ? JoinEnd{} : endAt(parts, pointer.world);
    if (!from_.valid()) {
        why_ = whyNoBeginning(parts, parts.tool, under_);
    } else if (parts.tool == Tool::wire && under_.object == from_.object) {
        why_.clear();
    } else if (pointer.overCard || !pointer.inside) {
        why_.clear();
    } else {
        why_ = whyNoJoin(parts, joinTo(parts, under_));
    }
}

bool JoinTool::press(EditParts& parts) {
    bool const again = parts.tool == Tool::wire && from_.valid() && under_.object == from_.object;
    if (from_.valid() && !again) { // the second click of a wire
        finish(parts);
        return false;
    }
    if (!under_.valid()) {
        return false;
    }
    if (!why_.empty()) {
        parts.tell(why_, render::ToastKind::Trouble);
        return false;
    }
    from_ = under_;
    start_ = parts.tool == Tool::wire ? parts.pointer.world : placeOnGrid(parts);
    pressedAt_ = parts.pointer.screen;
    return true;
}

void JoinTool::release(EditParts& parts) {
    if (parts.tool == Tool::wire && isClick(parts)) {
        return; // the next click ends it
    }
    if (parts.pointer.overCard || !parts.pointer.inside) { // nothing lies there, not even the world
        cancel();
        return;
    }
    finish(parts);
}

void JoinTool::finish(EditParts& parts) {
    bool const wire = parts.tool == Tool::wire;
    if (wire && under_.valid() && (under_.object == from_.object || !why_.empty())) {
        if (!why_.empty()) { // the wire can still end elsewhere
            parts.tell(why_, render::ToastKind::Trouble);
        }
        return;
    }
    Join const join = joinTo(parts, under_);
    JoinEnd const from = std::exchange(from_, {});
    if (!from.valid() || (wire && !join.to.valid())) {
        return; // onto the paper: no wire
    }
    if (!why_.empty()) {
        parts.tell(std::exchange(why_, {}), render::ToastKind::Trouble);
    } else if (wire) {
        actions::connectObjects(parts, join.from.name, join.to.name);
    } else {
        actions::joinObjects(parts, join.from.name, join.to.name, join.at, join.atB);
    }
}

bool JoinTool::cancel() {
    return std::exchange(from_, {}).valid();
}

} // namespace trembler::ui
