// Shapes and other properties of an object, scaled and mirrored.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"

namespace trembler::edit {

/// Scales the shape and the poles of an object along the axes of the world; both factors are above zero.
/// Throws CommandError if the result is no possible shape, or factors differ and a piece cannot follow.
void scaleEntry(GameData const& data, Json& entry, Vec2 factors);
/// Mirrors an object in its place: at a vertical line through it, or at a horizontal one.
void mirrorEntry(GameData const& data, Json& entry, bool atVertical);

} // namespace trembler::edit
