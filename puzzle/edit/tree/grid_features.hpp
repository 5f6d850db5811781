// What of an object can lie on a grid: its edges, its corners and its place.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"

#include <string>
#include <vector>

namespace trembler::edit {

/// Coordinates, m, each once, ascending.
struct GridFeatures {
    std::vector<double> x;
    std::vector<double> y;
};

/// Those of objects: the places of the entries and, of each of their pieces, the corners and the leftmost,
/// rightmost, lowest and highest point. Objects that do not exist have none.
[[nodiscard]] GridFeatures gridFeatures(GameData const& data, Json const& level,
                                        std::vector<std::string> const& names);

/// Whether a coordinate, m, is that of a line of a grid of this step, m, above zero, as exactly as files
/// state it.
[[nodiscard]] bool liesOnGrid(double value, double step);

/// The way, m, along one axis by which features are moved if they are dragged by `way`, m: what lies on the
/// grid stays on it. If one of them does, it is a multiple of the grid's step. If none does, it is the way
/// nearest to `way` that takes one of them to the grid; a way of less than half a step is none, so that an
/// object that is dragged sideways keeps its height. `step`: m, above zero.
[[nodiscard]] double wayOnGrid(std::vector<double> const& features, double way, double step);

} // namespace trembler::edit
