// Shows all properties of one object, from their own descriptions, and derived values of the current frame.
#pragma once

#include "game/ui/shared/layout.hpp"
#include "runtime/world/world.hpp"

#include <string>
#include <vector>

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
/// view requests the world's Sounds, as SoundView does. Empty if the object does not exist.
[[nodiscard]] std::vector<InspectorSection> inspect(World const& world, ObjectId object);

/// A number for people: about four digits; from 1e7 and below 1e-3 three digits with an exponent; "0" below
/// 1e-9.
[[nodiscard]] std::string readable(double value);

/// The inspector's card. Follows an object by its name, because ids are valid only within a run.
class Inspector {
public:
    void show(std::string name) { name_ = std::move(name); }
    void close() { name_.clear(); }
    [[nodiscard]] bool open() const { return !name_.empty(); }
    [[nodiscard]] std::string const& name() const { return name_; }

    /// Call between Gui::beginFrame and endFrame. `top`, the distance from the window's top, and the maximum
    /// `height` are in pixels at UI scale 1.
    void draw(Layout& layout, World const& world, float top, float height);
    /// The sections drawn last.
    [[nodiscard]] std::vector<InspectorSection> const& shown() const { return shown_; }

private:
    std::string name_;
    std::vector<InspectorSection> shown_;
};

} // namespace trembler::ui
