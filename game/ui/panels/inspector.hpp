// Shows all properties of one object, from their own descriptions, and derived values of the current frame.
#pragma once

#include "game/ui/shared/card_sizes.hpp"
#include "game/ui/shared/layout.hpp"
#include "puzzle/session/session.hpp"

#include <optional>
#include <string>
#include <vector>

namespace trembler::lua {
class LiveScripts;
}

namespace trembler::ui {

/// One line: a field of a property, or a derived value.
struct InspectorRow {
    std::string name;
    std::string value;
    std::string unit;
    std::string meaning;
};

/// One property with its fields.
struct InspectorSection {
    std::string title;
    std::string meaning;
    std::vector<InspectorRow> rows;
};

/// The inspector's contents for an object: first derived values (speed, electricity, contacts, forces,
/// sound), then all its properties in order of keys. The sound level is known only while some component or
/// view requests the world's Sounds, as SoundView does. Empty if the object does not exist. `scripts` are the
/// scripts that the object may name, for the values of their parameters; nullptr: only its own statements are
/// shown.
[[nodiscard]] std::vector<InspectorSection> inspect(World const& world, ObjectId object,
                                                    lua::LiveScripts const* scripts = nullptr);

/// The inspector's card. Follows an object through all runs of its session (LastingObject), whatever its
/// name.
class Inspector {
public:
    /// Shows an object of the session's world; closes the card for an invalid id.
    void show(Session const& session, ObjectId object);
    void close() { subject_.reset(); }
    /// The scripts of the level's mods; they must outlive it. nullptr: it has none.
    void setScripts(lua::LiveScripts const* scripts) { scripts_ = scripts; }
    [[nodiscard]] bool open() const { return subject_.has_value(); }
    /// The object that is shown, in the session's world as it is now; an invalid id if the card is closed or
    /// the object is not there.
    [[nodiscard]] ObjectId object(Session const& session) const;
    /// What is shown, in all worlds of the session; nothing: the card is closed.
    [[nodiscard]] std::optional<LastingObject> const& subject() const { return subject_; }
    /// The name that it has, or had last, while the card is open.
    [[nodiscard]] std::string const& name() const { return name_; }

    /// Call between Gui::beginFrame and endFrame. `past` is the world that is shown in place of the
    /// session's; nullptr: none. `whyTip` is the tip of the button *Why?*; nullptr: there is nothing to ask
    /// about. True if the player asks why about the object.
    [[nodiscard]] bool draw(Layout& layout, Session const& session, SidePlace const& place,
                            World const* past = nullptr, char const* whyTip = nullptr);
    /// The sections drawn last.
    [[nodiscard]] std::vector<InspectorSection> const& shown() const { return shown_; }

private:
    std::optional<LastingObject> subject_;
    std::string name_; // as of the last picture in which it was there
    std::vector<InspectorSection> shown_;
    lua::LiveScripts const* scripts_ = nullptr;
};

} // namespace trembler::ui
