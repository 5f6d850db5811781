// Finds the objects of a world that the conditions of its level refer to.
#pragma once

#include "puzzle/goals/model/condition.hpp"
#include "runtime/world/world.hpp"

#include <map>
#include <string_view>
#include <vector>

namespace trembler {

/// Finds objects in a world that was built from the level, and complains about conditions on objects that
/// lack what these need. Knows the objects that exist when it is made.
class ObjectFinder {
public:
    /// All three must outlive it.
    ObjectFinder(LevelFile const& level, World const& world, Problems& problems);
    /// All objects that the selector refers to, ascending: those with its names, and those that the level or
    /// the player made from its parts (Origin). `it` is the object that "it" refers to.
    [[nodiscard]] std::vector<ObjectId> find(Selector const& selector, ObjectId it) const;
    /// Complains if an object that the selector names does not have the property. `why` follows the object's
    /// name in the message, for example "is no conductor, so it is never on".
    void mustHave(Selector const& selector, PropertyInfo const& property, std::string_view why) const;
    [[nodiscard]] World const& world() const { return world_; }
    /// The greatest number of objects, each counted for every condition that refers to it. That number can be
    /// far greater than the file is long, so a small file could ask for more memory than there is.
    static constexpr std::size_t most = 4000000;
    /// Counts so many objects more. False once there are more than `most` in all; the first time it complains
    /// about the condition at `path`.
    [[nodiscard]] bool take(std::size_t objects, std::string const& path) const;

private:
    LevelFile const& level_;
    World const& world_;
    Problems& problems_;
    std::map<std::uint32_t, std::vector<ObjectId>> byPrototype_; // ascending
    mutable std::size_t taken_ = 0;
};

} // namespace trembler
