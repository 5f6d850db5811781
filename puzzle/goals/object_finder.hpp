// The objects of a world that goals speak of.
#pragma once

#include "puzzle/goals/condition.hpp"
#include "runtime/world/world.hpp"

#include <map>
#include <vector>

namespace trembler {

/// Turns selectors into objects of a world and complains about what cannot be.
class ObjectFinder {
public:
    ObjectFinder(LevelFile const& level, World const& world, Problems& problems);
    /// All objects that the selector names, ascending; `it` stands for "it".
    [[nodiscard]] std::vector<ObjectId> find(Selector const& selector, ObjectId it) const;
    /// Complains if an object that is named outright does not have the property; `why` says what it lacks it
    /// for.
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
    std::map<std::string, std::vector<ObjectId>> byPart_;
    mutable std::size_t taken_ = 0;
};

} // namespace trembler
