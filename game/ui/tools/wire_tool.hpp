// Laying wires while building: from one conductor to another.
#pragma once

#include "game/ui/shared/pointer.hpp"
#include "puzzle/session/session.hpp"
#include "render/panels/toasts.hpp"
#include "render/scene/objects/wires.hpp"

#include <string>

namespace trembler::ui {

/// Two tools of the building phase: wire, and scissors that put the player's wires back. At most one is in
/// the hand. Window thread only.
class WireTool {
public:
    WireTool(Session& session, render::Toasts& toasts) : session_(session), toasts_(toasts) {}

    void switchLaying();
    void switchCutting();
    /// Puts the tool away, or first the wire whose end it holds. False if there was neither.
    bool cancel();
    void reset();
    /// Handles one picture's mouse input; `hovered` is the object under the mouse. A wire is dragged from
    /// object to object, or both are clicked; an end that is refused leaves it in the hand. True if the mouse
    /// belongs to the tool.
    bool update(Pointer const& pointer, ObjectId hovered);

    [[nodiscard]] bool laying() const { return laying_; }
    [[nodiscard]] bool cutting() const { return cutting_; }
    /// The object from which a wire is being laid, or an invalid id.
    [[nodiscard]] ObjectId from() const { return session_.find(from_); }
    /// The object at which it would end, or an invalid id: then it ends at the mouse.
    [[nodiscard]] ObjectId to() const { return to_; }
    /// Why the wire, or the object under the mouse as its beginning, is refused; empty if it is not.
    [[nodiscard]] std::string const& why() const { return why_; }
    /// The wire that a click of the scissors would put back; both ids invalid if there is none.
    [[nodiscard]] render::Link const& wireUnderBlades() const { return wire_; }

private:
    void cut(Pointer const& pointer);
    void finish();
    [[nodiscard]] bool conducts(ObjectId object) const;
    /// Why the wire in the hand cannot end there; empty if it can.
    [[nodiscard]] std::string whyNotTo(ObjectId object) const;

    Session& session_;
    render::Toasts& toasts_;
    bool laying_ = false;
    bool cutting_ = false;
    LastingObject from_; // default: none
    ObjectId to_;
    render::Point pressedAt_; // pixels
    bool dragging_ = false;   // the press that began the wire lasts
    std::string why_;
    render::Link wire_;
};

} // namespace trembler::ui
