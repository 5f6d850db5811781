// All properties of one object, from their own descriptions, and what follows from them at the moment.
#pragma once

#include "game/ui/shared/layout.hpp"
#include "runtime/world/world.hpp"

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

/// The card. Follows an object by its name, as ids do not outlive a run.
class Inspector {
public:
    void show(std::string name) { name_ = std::move(name); }
    void close() { name_.clear(); }
    [[nodiscard]] bool open() const { return !name_.empty(); }
    [[nodiscard]] std::string const& name() const { return name_; }

    /// Between Gui::beginFrame and endFrame, in pixels at UI scale 1: how far from the window's top it
    /// stands, and how high it may be.
    void draw(Layout& layout, World const& world, float top, float height);
    /// What was last drawn.
    [[nodiscard]] std::vector<InspectorSection> const& shown() const { return shown_; }

private:
    std::string name_;
    std::vector<InspectorSection> shown_;
};

} // namespace trembler::ui
