// All properties of one object, from their own descriptions, and what follows from them at the moment.
#pragma once

#include "game/ui/shared/layout.hpp"
#include "puzzle/session/session.hpp"

#include <optional>
#include <string>
#include <vector>

namespace trembler::ui {

/// One line: a field of a property, or something derived.
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

/// What the inspector says of an object: first what goes on with it (speed, electricity, contacts, forces,
/// sound), then every property that it has, in order of keys. How loud an object is it knows while
/// somebody wants the world's Sounds, as SoundView does. Empty if the object does not exist.
[[nodiscard]] std::vector<InspectorSection> inspect(World const& world, ObjectId object);

/// A number as people read it: four digits, SI's own spelling of what is very large or small.
[[nodiscard]] std::string readable(double value);

/// The card. Follows an object through all runs of its session (LastingObject), whatever it is called there.
class Inspector {
public:
    /// Shows an object of the session's world; closes the card for an invalid id.
    void show(Session const& session, ObjectId object);
    void close() { subject_.reset(); }
    [[nodiscard]] bool open() const { return subject_.has_value(); }
    /// What is shown, in the session's world as it is now; an invalid id if the card is closed or the object
    /// is not there.
    [[nodiscard]] ObjectId object(Session const& session) const;
    /// What it is called, or was last called, while the card is open.
    [[nodiscard]] std::string const& name() const { return name_; }

    /// Between Gui::beginFrame and endFrame, in pixels at UI scale 1: how far from the window's top it
    /// stands, and how high it may be.
    void draw(Layout& layout, Session const& session, float top, float height);
    /// What was last drawn.
    [[nodiscard]] std::vector<InspectorSection> const& shown() const { return shown_; }

private:
    std::optional<LastingObject> subject_;
    std::string name_; // as of the last picture in which it was there
    std::vector<InspectorSection> shown_;
};

} // namespace trembler::ui
