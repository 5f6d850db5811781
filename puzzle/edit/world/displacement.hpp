// Puts the objects of a world that was built from a level where another tree of it has them.
#pragma once

#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/magnetism/properties.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace trembler::edit {

/// Of the properties in a world only those change that drawing and picking read: positions, angles, shapes,
/// poles and joints. Not thread-safe.
class Displacement {
public:
    /// The world was built from this level, which was read from this tree and may lack some of its entries.
    /// The data must outlive this.
    Displacement(GameData const& data, Json tree, LevelFile const& level, World const& world);

    /// Whether the world shows this tree now. False, and the world may show a part of the difference, if the
    /// trees differ in more than the places of objects and joints, the sizes of objects that are one piece,
    /// areas for placing, and goals. A world that was followed to one tree can be followed to the next.
    [[nodiscard]] bool follow(Json const& tree, World& world);

private:
    /// An object of the world, as it was built.
    struct Piece {
        ObjectId id;
        std::optional<Position> position;
        std::optional<Rotation> rotation;
        std::optional<Shape> shape;
        std::optional<MagneticPoles> poles;
        std::optional<Joint> joint;
    };
    struct Entry {
        std::vector<Piece> pieces;
        bool displaced = false;
    };

    [[nodiscard]] bool differsElsewhere(Json const& tree) const;
    [[nodiscard]] bool moveObject(Json const& before, Json const& now, Entry const& entry,
                                  World& world) const;
    [[nodiscard]] bool resize(Json const& now, Piece const& piece, World& world) const;

    GameData const& data_;
    Json tree_;
    std::vector<Entry> objects_; // by index in the tree
    std::vector<Entry> joints_;
};

} // namespace trembler::edit
