// The objects of a level as a search sees them: outlines, and which of them can be moved or connected.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/world.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler::insight {

/// An upright rectangle around something, m.
struct Outline {
    Vec2 low;
    Vec2 high;
    [[nodiscard]] Vec2 middle() const { return 0.5 * (low + high); }
};

/// Between the nearest points of two outlines; 0 if they overlap.
[[nodiscard]] double distance(Outline const& a, Outline const& b);
/// Around points, of which there must be one at least.
[[nodiscard]] Outline outlineOf(std::span<Vec2 const> points);
/// Around all pieces of a placed part; nothing if it has no shape.
[[nodiscard]] std::optional<Outline> outlineOf(PartLibrary const& parts, Placement const& placement);

struct Thing {
    std::string name;
    std::string part; ///< that it was made from; may be empty
    Vec2 at;          ///< m
    Outline outline;
    bool movable = false;
    bool conductor = false;
    bool magnet = false;
    bool liquid = false;
};

/// All objects with a shape, in order of their ids.
[[nodiscard]] std::vector<Thing> thingsIn(World const& world);

} // namespace trembler::insight
