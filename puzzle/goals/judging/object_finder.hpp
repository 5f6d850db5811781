// From what a condition of a level speaks of to objects of a world.
#pragma once

#include "puzzle/goals/model/condition.hpp"
#include "runtime/world/world.hpp"

#include <map>
#include <string_view>
#include <vector>

namespace trembler {

/// Finds the objects of conditions in a world that was built from the level, and complains about conditions
/// that cannot be. Knows the objects that exist when it is made.
class ObjectFinder {
public:
    /// All three must outlive it.
    ObjectFinder(LevelFile const& level, World const& world, Problems& problems);
    /// All objects that the selector speaks of, ascending: those of its names, and those that the level or
    /// the player made from its parts (Origin); `it` stands for "it".
    [[nodiscard]] std::vector<ObjectId> find(Selector const& selector, ObjectId it) const;
    /// Complains if an object that the selector names does not have the property; `why` says what it cannot
    /// do without it.
    void mustHave(Selector const& selector, PropertyInfo const& property, std::string_view why) const;
    [[nodiscard]] World const& world() const { return world_; }
    /// Conditions that name many objects, each in many ways, are products of what a file states: a small file
    /// could ask for more memory than there is.
    static constexpr std::size_t most = 4000000;
    /// Counts objects that conditions speak of. False, with a complaint about `path` the first time, once
    /// there are more than `most` in all.
    [[nodiscard]] bool take(std::size_t objects, std::string const& path) const;

private:
    LevelFile const& level_;
    World const& world_;
    Problems& problems_;
    std::map<std::uint32_t, std::vector<ObjectId>> byPrototype_; // ascending
    mutable std::size_t taken_ = 0;
};

} // namespace trembler
