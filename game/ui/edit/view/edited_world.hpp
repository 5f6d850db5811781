// The world that the editor shows: the level as it would start, or as much of it as can be built.
#pragma once

#include "runtime/level/build/build_world.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler::ui {

/// Window thread only. The registry and the parts must outlive it.
class EditedWorld {
public:
    /// Builds the world of a level. Entries that cannot be built are left out and named by leftOut(): a level
    /// under construction is seen all the same. Never throws InputError.
    void build(Registry const& registry, PartLibrary const& parts, LevelFile const& level);

    /// nullptr until something was built.
    [[nodiscard]] World const* world() const { return world_.get(); }
    /// The object of an entry of "objects" or "joints"; an invalid id if it was left out.
    [[nodiscard]] ObjectId objectOf(std::size_t entry) const;
    [[nodiscard]] ObjectId jointOf(std::size_t entry) const;
    /// The entry of "objects" that an object was made from.
    [[nodiscard]] std::optional<std::size_t> entryOf(ObjectId object) const;
    /// How many entries could not be built.
    [[nodiscard]] std::size_t leftOut() const { return leftOut_; }

private:
    std::unique_ptr<World> world_;
    std::vector<ObjectId> objects_;
    std::vector<ObjectId> joints_;
    std::size_t leftOut_ = 0;
};

} // namespace trembler::ui
