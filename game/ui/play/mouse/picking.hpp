// Which object the mouse points at, and which one is looked at closely.
#pragma once

#include "game/ui/panels/inspector.hpp"
#include "game/ui/shared/pointer.hpp"
#include "puzzle/session/session.hpp"

namespace trembler::ui {

/// Window thread only.
class Picking {
public:
    /// Both must outlive this.
    Picking(Session const& session, Inspector& inspector) : session_(session), inspector_(inspector) {}

    /// Once per picture; nothing is pointed at where a card lies, or outside of the window.
    void pointAt(Pointer const& pointer);
    /// Under the mouse; an invalid id if there is nothing.
    [[nodiscard]] ObjectId hovered() const { return hovered_; }
    /// The session's world is another one: ids of the old one mean nothing in it.
    void forget() { hovered_ = {}; }

    /// Opens the inspector on an object; closes it for an invalid id.
    void inspect(ObjectId object);

private:
    Session const& session_;
    Inspector& inspector_;
    ObjectId hovered_;
};

} // namespace trembler::ui
