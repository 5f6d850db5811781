// Commands on a level's contents other than objects: texts, hints, toolbox, areas for placing, mods.
#pragma once

#include "puzzle/edit/document/command.hpp"
#include "runtime/level/model/level.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace trembler::edit {

// Indices are those of the file's lists; one that does not exist throws CommandError.

[[nodiscard]] Command setTitle(Json const& level, std::string const& title); ///< refuses one that is no name
[[nodiscard]] Command setText(Json const& level, std::string const& text);   ///< an empty one is removed
[[nodiscard]] Command setDemonstration(Json const& level, bool demonstration);
[[nodiscard]] Command setMods(Json const& level, std::vector<std::string> const& mods);

[[nodiscard]] Command addHint(Json const& level, std::string const& hint);
[[nodiscard]] Command setHint(Json const& level, std::size_t index, std::string const& hint);
[[nodiscard]] Command removeHint(Json const& level, std::size_t index);
[[nodiscard]] Command moveHint(Json const& level, std::size_t from, std::size_t to);

/// Adds a part to the toolbox, or to its count if it is there.
[[nodiscard]] Command addTool(Json const& level, std::string const& part, int count = 1);
[[nodiscard]] Command setToolCount(Json const& level, std::size_t index,
                                   int count); ///< 1 to 1000, or unlimitedCount
[[nodiscard]] Command removeTool(Json const& level, std::size_t index);
[[nodiscard]] Command moveTool(Json const& level, std::size_t from, std::size_t to);

/// How many wires the player may lay; 0: none. Not by setToolCount(): they are no part.
[[nodiscard]] Command setWires(Json const& level, int count); ///< 0 to 1000, or unlimitedCount

/// A new step of a beginner's first lesson, of one of the kinds of files: "place", "wire", "run", "grab",
/// "cut". Parts and objects that it needs are the first of `names`; nullopt if there are not enough.
[[nodiscard]] std::optional<Json> newStep(std::string const& kind, std::vector<std::string> const& names,
                                          Vec2 at);
[[nodiscard]] Command addStep(Json const& level, Json const& step);
[[nodiscard]] Command setStep(Json const& level, std::size_t index, Json const& step);
[[nodiscard]] Command removeStep(Json const& level, std::size_t index);
[[nodiscard]] Command moveStep(Json const& level, std::size_t from, std::size_t to);

/// An area in the form of files: [x, y, width, height] or [[x, y], ...], rounded to a nanometre.
[[nodiscard]] Json areaJson(Area const& area);
/// An area for placing parts. The first one ends that parts may be placed anywhere.
[[nodiscard]] Command addPlacingArea(Json const& level, Area const& area);
[[nodiscard]] Command setPlacingArea(Json const& level, std::size_t index, Area const& area);
/// Removes an area. Without the last one nothing can be placed anywhere: see placeAnywhere().
[[nodiscard]] Command removePlacingArea(Json const& level, std::size_t index);
/// Removes "placing": parts may be placed anywhere within the bounds.
[[nodiscard]] Command placeAnywhere(Json const& level);

} // namespace trembler::edit
