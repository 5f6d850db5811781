// The hand while the world runs: drags objects, selects them, cuts wires.
#pragma once

#include "game/ui/shared/pointer.hpp"
#include "game/ui/tools/hand_lead.hpp"
#include "puzzle/session/session.hpp"
#include "render/panels/toasts.hpp"
#include "render/scene/objects/wires.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace trembler::ui {

/// Acts on the world only through Session::feed, so that a run can be replayed. Window thread only.
class HandTool {
public:
    /// `hand`: which of the two hands it is, 0 or 1.
    HandTool(Session& session, render::Toasts& toasts, std::uint8_t hand = 0)
        : session_(session), toasts_(toasts), hand_(hand) {}

    /// Handles one picture's mouse input; `hovered` is the object under the mouse. Returns the object that
    /// was clicked without being dragged: an invalid id for a click on empty space, nullopt if there was no
    /// click.
    std::optional<ObjectId> update(Pointer const& pointer, ObjectId hovered, double seconds);
    /// Sends the hand's inputs since the last frame to the session; call it directly before each
    /// Session::step.
    void beforeStep();
    /// Releases the object that it holds.
    void letGo();
    /// The run is over: nothing is held any more.
    void reset();

    void setCutting(bool on) { cutting_ = on; }
    [[nodiscard]] bool cutting() const { return cutting_; }
    /// The wire that a click would cut; both ids invalid if there is none.
    [[nodiscard]] render::Link const& wireUnderBlades() const { return wire_; }
    /// The wire that was cut since the last call; both ids invalid if there is none.
    [[nodiscard]] render::Link takeCut() { return std::exchange(cut_, {}); }
    /// The held object, or an invalid id.
    [[nodiscard]] ObjectId held() const { return held_; }
    /// Where the pointer is that drags it, m; nothing while nothing is held. The hand pulls to a place ahead
    /// of it: see HandLead.
    [[nodiscard]] std::optional<Vec2> pointer() const {
        return held_.valid() ? std::optional(target_) : std::nullopt;
    }
    /// An object is pressed, but may not be held yet.
    [[nodiscard]] bool busy() const { return press_.has_value() || held_.valid(); }

private:
    struct Press {
        ObjectId object;
        Vec2 at;
        render::Point screen;
        double seconds = 0;
    };

    void cut(Pointer const& pointer);
    void grab(Press const& press);
    [[nodiscard]] bool movable(ObjectId object) const;
    /// The world's hands have no strength: in such a level only placed parts act.
    [[nodiscard]] bool handless() const;

    Session& session_;
    render::Toasts& toasts_;
    std::uint8_t hand_;
    std::optional<Press> press_;
    std::vector<PlayerInput> waiting_; // for the next frame
    ObjectId held_;
    Vec2 target_;     // of the pointer
    Vec2 sentTarget_; // the last target that was fed to the session
    HandLead lead_;
    bool cutting_ = false;
    render::Link wire_;
    render::Link cut_;
};

} // namespace trembler::ui
