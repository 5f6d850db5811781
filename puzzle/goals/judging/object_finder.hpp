// Finds the objects of a world that the conditions of its level refer to.
#pragma once

#include "puzzle/goals/model/condition.hpp"
#include "runtime/world/world.hpp"

#include <map>
#include <string_view>
#include <vector>

namespace trembler {

/// Finds objects in a world that was built from the level, and complains about objects that lack the
/// properties that their conditions need. Finds only objects that exist when the finder is constructed.
class ObjectFinder {
public:
    /// All arguments must outlive it.
    ObjectFinder(LevelFile const& level, World const& world, Problems& problems);
    /// All objects that the selector refers to, ascending; none once full(). These are objects with its
    /// names, and objects that the level or the player made from its parts (Origin); of a composite part, the
    /// main pieces. Complains about names that no object has. `it` is the object that "it" refers to.
    [[nodiscard]] std::vector<ObjectId> find(Selector const& selector, ObjectId it) const;
    /// Complains if an object that the selector names does not have the property. `why` follows the object's
    /// name in the message, for example "is no conductor, so it is never on".
    void mustHave(Selector const& selector, PropertyInfo const& property, std::string_view why) const;
    [[nodiscard]] World const& world() const { return world_; }
    /// The greatest total number of objects of all conditions; an object counts once for each condition that
    /// refers to it. Without this limit a small file could demand more memory than there is.
    static constexpr std::size_t most = 4000000;
    /// Adds to the total number of objects. False once it exceeds `most`; the first time it then complains
    /// about the condition at `path`.
    [[nodiscard]] bool take(std::size_t objects, std::string const& path) const;
    /// Whether the total number of objects has exceeded `most`: the goals are refused, so nothing more is
    /// found or checked, which would take a time that the level's size does not limit.
    [[nodiscard]] bool full() const { return taken_ > most; }

private:
    LevelFile const& level_;
    World const& world_;
    Problems& problems_;
    std::map<std::uint32_t, std::vector<ObjectId>> byPrototype_; // ascending
    mutable std::size_t taken_ = 0;
};

} // namespace trembler
