// Whether a part lies wholly where a level allows parts.
#pragma once

#include "physics/box_tree.hpp"
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"

#include <optional>
#include <span>
#include <string>

namespace trembler {

/// How far, in m, a part may stick out of the areas for placing: as far as two placed parts may overlap, and
/// for the same reason.
inline constexpr double allowedOutside = 0.01;

/// The rectangle around an area; a polygon must have corners.
[[nodiscard]] Bounds boundsOf(Area const& area);

/// Whether the whole outline of a placed shape lies in the areas together, or outside them by no more than
/// `allowed` (m). The outline is looked at in steps of 2 cm (of a very large shape: a thousandth of its
/// side), so a gap between two areas counts only if it is wider than 2 `allowed`.
[[nodiscard]] bool liesWithin(PlacedShape const& placed, std::span<Area const> areas, double allowed);

/// Why a part may not be placed there although its centre may be (see checkPlacement()): it would stick out
/// of the areas for placing, or of the level's bounds if there are no such areas. In words for the player;
/// nothing if it lies wholly inside. Of a composite, all pieces with a shape count.
///
/// Only a place that a player chooses is judged so. Solutions that are loaded, recorded ones among them, are
/// judged by the centres of their parts, as a level may have been recorded before its areas were drawn.
[[nodiscard]] std::optional<std::string> whyItSticksOut(LevelFile const& level, PartLibrary const& parts,
                                                        Placement const& placement);

} // namespace trembler
