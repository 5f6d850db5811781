// Commands that move, turn, scale, mirror, align and distribute objects.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/math/vec2.hpp"

#include <optional>
#include <string>
#include <vector>

namespace trembler::edit {

// All of them leave out locked objects, and throw CommandError if nothing is left, or an object does not
// exist. Joints go with their objects: a joint whose objects are all moved is moved, and so is one that holds
// a single object to the world; of a rope, spring, distance or pulley each end goes with its object, and an
// end at the wall stays, unless the object is mirrored. Lengths are m. Results are rounded to a nanometre and
// a millionth of a degree, so that files have no rounding errors.

[[nodiscard]] Command moveObjects(GameData const& data, Json const& level,
                                  std::vector<std::string> const& names, Vec2 by);
/// Turns objects anticlockwise around `centre`.
[[nodiscard]] Command rotateObjects(GameData const& data, Json const& level,
                                    std::vector<std::string> const& names, double degrees, Vec2 centre);
/// Scales objects, their distances from `centre` included; both factors must be above zero. Shapes of the
/// objects' parts are overridden. Discs, capsules, and turned pieces cannot be scaled by different factors
/// along x and y: the command is then refused, as is one that leaves the range of a measure. An object
/// without a shape is only moved.
[[nodiscard]] Command scaleObjects(GameData const& data, Json const& level,
                                   std::vector<std::string> const& names, Vec2 factors, Vec2 centre);
/// Whether scaleObjects() would accept these factors.
[[nodiscard]] bool mayScale(GameData const& data, Json const& level, std::vector<std::string> const& names,
                            Vec2 factors);

enum class Mirror {
    leftRight, ///< at a vertical line
    upDown,    ///< at a horizontal line
};
/// Mirrors objects at a line through `centre`. Shapes of the objects' parts are overridden where they are not
/// symmetric, and so are velocities and the axis of magnets.
[[nodiscard]] Command mirrorObjects(GameData const& data, Json const& level,
                                    std::vector<std::string> const& names, Mirror mirror, Vec2 centre);

enum class Alignment { left, right, top, bottom, centresX, centresY };
/// Moves objects so that their extents end at the outermost one's edge, or their centres lie on one line.
/// Members of a group stay together: a group is aligned as one.
[[nodiscard]] Command alignObjects(GameData const& data, Json const& level,
                                   std::vector<std::string> const& names, Alignment alignment);
enum class Axis { x, y };
/// Moves objects, or groups of them, so that the gaps between them are equal; the outermost ones stay. Needs
/// three.
[[nodiscard]] Command distributeObjects(GameData const& data, Json const& level,
                                        std::vector<std::string> const& names, Axis axis);

} // namespace trembler::edit
