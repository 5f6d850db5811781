// Which object the mouse points at, and which one the inspector shows.
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

    /// The world that is on the screen in place of the session's, in pictures from now on; nullptr: nothing
    /// is.
    void show(World const* past) { past_ = past; }
    /// To be called once per picture. Over a card or outside the window the mouse points at nothing.
    void pointAt(Pointer const& pointer);
    /// The object under the mouse, or an invalid id.
    [[nodiscard]] ObjectId hovered() const { return hovered_; }
    /// The session has another world, in which ids of the old one mean nothing.
    void forget() { hovered_ = {}; }

    /// Opens the inspector on an object; closes it for an invalid id.
    void inspect(ObjectId object);

private:
    Session const& session_;
    Inspector& inspector_;
    World const* past_ = nullptr;
    ObjectId hovered_;
};

} // namespace trembler::ui
