// Reads fields of a running world by name, frame by frame: for tables of numbers and for probes.
#pragma once

#include "insight/probe/watched_fields.hpp"
#include "runtime/world/world.hpp"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace trembler::watch {

/// Empty, a number in the unit of its column, or text.
using Cell = std::variant<std::monostate, double, std::string>;

/// One field of one object, found by the object's name in each frame: the object may be destroyed and created
/// again. Only reads; valid as long as the registry lives.
class Watch {
public:
    /// `asked` is the user's text for the field and becomes the column's heading.
    Watch(std::string asked, std::string object, WatchedField field)
        : asked_(std::move(asked)), object_(std::move(object)), field_(std::move(field)) {}

    [[nodiscard]] std::string const& asked() const { return asked_; }
    [[nodiscard]] std::string const& object() const { return object_; }
    [[nodiscard]] WatchedField const& field() const { return field_; }
    /// Headings of its columns; a whole vector has two: "ball.position.x [m]".
    [[nodiscard]] std::vector<std::string> headers() const;
    /// One cell per column for the current frame; empty while the object does not exist, lacks the property,
    /// or the value is unknown, or the list has no element of that number.
    [[nodiscard]] std::vector<Cell> read(World const& world) const;

private:
    [[nodiscard]] std::size_t columns() const;

    std::string asked_;
    std::string object_;
    WatchedField field_;
};

/// WatchedField::component of ".length".
inline constexpr int lengthComponent = 2;

/// Resolves "OBJECT.FIELD" in a built world: FIELD is a property with a single value, as "mass"; a property
/// and one of its fields, as "magnetic_force.force"; or a field alone, as "current", if only one property of
/// the object has it. Elements of lists have numbers from 0: "shape.0.width"; "shape.count" is the number of
/// elements; ".x" and ".y" after a vector are one of its components, ".length" is its length: a speed, a
/// force. The object "world" has the properties of the world as a whole. Throws std::invalid_argument that
/// suggests similar names or lists all of them.
[[nodiscard]] Watch find(World const& world, std::vector<WatchedField> const& fields, std::string_view what);

/// Whether an object of this name, or "world", can have the field, as far as is known now.
[[nodiscard]] bool concerns(World const& world, WatchedField const& field, std::string const& object);
/// The names of all objects, sorted.
[[nodiscard]] std::vector<std::string> objectNames(World const& world);

} // namespace trembler::watch
