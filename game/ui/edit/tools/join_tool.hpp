// Drawing wires and joints: from a piece to another one, by a drag or, of wires, by two clicks, as in play.
#pragma once

#include "game/ui/edit/tools/join_ends.hpp"

#include <string>

namespace trembler::ui {

/// Acts while the tool is the one for wires or for joints. Window thread only.
class JoinTool {
public:
    /// Looks at what is under the pointer; to be called once per picture, before the others.
    void look(EditParts const& parts);
    /// A press of the button: it begins at what is under the pointer, or ends there. Returns whether a drag
    /// has begun. A wire whose end is refused stays in the hand.
    bool press(EditParts& parts);
    /// The end of that drag.
    void release(EditParts& parts);
    /// Lets go of the end that was begun. False if there was none.
    bool cancel();

    /// Where it began; not valid while nothing is begun.
    [[nodiscard]] JoinEnd const& from() const { return from_; }
    /// Where it would go or begin: under the pointer; not valid over the paper.
    [[nodiscard]] JoinEnd const& under() const { return under_; }
    /// Why it cannot go or begin there; empty if it can.
    [[nodiscard]] std::string const& why() const { return why_; }
    /// Where on the scene it began, on the grid for joints, m.
    [[nodiscard]] Vec2 start() const { return start_; }

private:
    [[nodiscard]] Join joinTo(EditParts const& parts, JoinEnd const& to) const;
    [[nodiscard]] bool isClick(EditParts const& parts) const;
    void finish(EditParts& parts);

    JoinEnd from_;
    JoinEnd under_;
    std::string why_;
    Vec2 start_;
    render::Point pressedAt_; // pixels
};

} // namespace trembler::ui
