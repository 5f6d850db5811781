// What wires and joints are drawn between: objects, and single pieces of composite parts, as in play.
#pragma once

#include "game/ui/edit/edit_parts.hpp"

#include <string>
#include <vector>

namespace trembler::ui {

/// An object of the edited world and its name in the level: of a piece "battery plus", of an entry's main
/// piece that of the entry. Invalid and empty: none. The id is that of the world in this picture only.
struct JoinEnd {
    ObjectId object{};
    std::string name;

    [[nodiscard]] bool valid() const { return object.valid(); }
};

/// A wire or a joint that is about to be made.
struct Join {
    Tool tool = Tool::wire; ///< wire or joint
    JoinEnd from;
    JoinEnd to; ///< not valid: the world; of a wire none yet
    Vec2 at;    ///< of a joint, m
    Vec2 atB;
};

/// The topmost piece under a point, or the nearest one within reach of the mouse, locked or not.
[[nodiscard]] JoinEnd endAt(EditParts const& parts, Vec2 at);
/// The end with this name in the level; not valid if the world has none.
[[nodiscard]] JoinEnd endNamed(EditParts const& parts, std::string const& name);
/// The ends that the selection stands for: each selected object, or the selected piece of it. For a wire, an
/// object that does not conduct itself stands for its only piece that does.
[[nodiscard]] std::vector<JoinEnd> selectedEnds(EditParts const& parts, Tool tool);

/// Why a wire or a joint cannot begin there, in words in the language in use; empty if it can.
[[nodiscard]] std::string whyNoBeginning(EditParts const& parts, Tool tool, JoinEnd const& from);
/// Why it cannot be made, in the same way.
[[nodiscard]] std::string whyNoJoin(EditParts const& parts, Join const& join);
/// Everything in the view that a wire or a joint of the chosen kind could begin at or, where `from` is valid,
/// go to. Kept in EditParts::joinables while nothing of that changes. Valid until the next call.
[[nodiscard]] std::vector<ObjectId> const& joinableInView(EditParts const& parts, JoinEnd const& from);

} // namespace trembler::ui
