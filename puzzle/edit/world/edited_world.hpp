// The world that the editor shows: the level as it would start, or as much of it as can be built.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/world/displacement.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/model/level.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler::edit {

/// Not thread-safe. The data must outlive it.
class EditedWorld {
public:
    /// Builds the world of a level, which was read from `tree` and may lack some of its entries. Entries that
    /// cannot be built are left out and counted by leftOut(): a level under construction is seen all the
    /// same. Never throws InputError.
    void build(GameData const& data, LevelFile const& level, Json const& tree);

    /// Shows a tree that differs from the one that the world was built from, or from which an earlier call
    /// led away, only in where objects and joints are and in sizes: for the steps of a drag, in a small part
    /// of the time that build() takes. What depends on places otherwise, as circuits do not, is not computed
    /// again, so build the world when the drag ends. False if the trees differ in something else; the world
    /// is then to be built.
    [[nodiscard]] bool follow(Json const& tree);

    /// nullptr until something was built.
    [[nodiscard]] World const* world() const { return world_.get(); }
    /// All objects that the entry with this name became: the pieces of a composite part, without its joints.
    /// Empty if there is none of that name.
    [[nodiscard]] std::span<ObjectId const> objectsOf(std::string const& name) const;
    /// The name of the entry that became an object of the world, or one of whose pieces the object is; by the
    /// object's origin, because the names of pieces may begin with those of other entries. "" for the object
    /// "world", for joints, and without a world.
    [[nodiscard]] std::string const& entryOf(ObjectId object) const;
    /// Which of objectsOf() its entry an object is: the index in PartStatements::pieces() of the entry's
    /// part, if that is a composite. The object must have an entry.
    [[nodiscard]] std::size_t pieceOf(ObjectId object) const;
    /// Another number whenever another world was built: ids of objects are those of one world.
    [[nodiscard]] std::uint64_t builds() const { return builds_; }
    /// How many entries could not be built.
    [[nodiscard]] std::size_t leftOut() const { return leftOut_; }

private:
    void noteObjects(std::span<LevelObject const> entries);

    std::unique_ptr<World> world_;
    std::size_t leftOut_ = 0;
    std::uint64_t builds_ = 0;
    std::optional<Displacement> displacement_;
    std::vector<std::vector<ObjectId>> objects_; // by number of their origin
    std::vector<std::string> entries_;           // their names, likewise
};

} // namespace trembler::edit
