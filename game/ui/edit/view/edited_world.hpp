// The world that the editor shows: the level as it would start, or as much of it as can be built.
#pragma once

#include "runtime/level/build/build_world.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"

#include <memory>

namespace trembler::ui {

/// Window thread only. The registry and the parts must outlive it.
class EditedWorld {
public:
    /// Builds the world of a level. Entries that cannot be built are left out and named by leftOut(): a level
    /// under construction is seen all the same. Never throws InputError.
    void build(Registry const& registry, PartLibrary const& parts, LevelFile const& level);

    /// nullptr until something was built.
    [[nodiscard]] World const* world() const { return world_.get(); }
    /// How many entries could not be built.
    [[nodiscard]] std::size_t leftOut() const { return leftOut_; }

private:
    std::unique_ptr<World> world_;
    std::size_t leftOut_ = 0;
};

} // namespace trembler::ui
