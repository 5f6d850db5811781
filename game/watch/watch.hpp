// Reading a field of a running world by name, frame by frame: for tables of numbers and for probes.
#pragma once

#include "game/watch/watched_fields.hpp"
#include "runtime/world/world.hpp"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace trembler::watch {

/// Nothing, a number in the unit of its column, or words.
using Cell = std::variant<std::monostate, double, std::string>;

/// One field of one object, by the object's name: it may come and go. Reads only, and is safe to keep for as
/// long as the registry lives.
class Watch {
public:
    /// `asked` is what stands above its columns: the words in which it was asked for.
    Watch(std::string asked, std::string object, WatchedField field)
        : asked_(std::move(asked)), object_(std::move(object)), field_(std::move(field)) {}

    [[nodiscard]] std::string const& object() const { return object_; }
    [[nodiscard]] WatchedField const& field() const { return field_; }
    /// What stands above its columns, one or, for a vector, two: "ball.position.x [m]".
    [[nodiscard]] std::vector<std::string> headers() const;
    /// One cell per column, as the world is now: empty ones while there is no such object, it has no such
    /// property, or nothing is known of it.
    [[nodiscard]] std::vector<Cell> read(World const& world) const;

private:
    std::string asked_;
    std::string object_;
    WatchedField field_;
};

/// What "OBJECT.FIELD" means in a world that has been built: FIELD is a property that has one value, as
/// "mass"; a property and one of its fields, as "magnetic_force.force"; or a field alone, as "current", where
/// only one property of the object can be meant. The object "world" has the properties of the world as a
/// whole. Throws std::invalid_argument, naming what is near or what there is.
[[nodiscard]] Watch find(World const& world, std::vector<WatchedField> const& fields, std::string_view what);

} // namespace trembler::watch
