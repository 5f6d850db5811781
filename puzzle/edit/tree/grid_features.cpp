#include "puzzle/edit/tree/grid_features.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shapes/corners.hpp"
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "puzzle/edit/tree/entry_pieces.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace trembler::edit {
namespace {

/// Files state places to a nanometre, and angles to a millionth of a degree: what differs by less than this
/// from the grid, m, lies on it.
constexpr double onGrid = 1e-7;
/// More features than this do not make a drag more exact.
constexpr std::size_t mostFeatures = 20000;

double onGridNearest(double value, double step) {
    return std::round(value / step) * step;
}

void addPoint(GridFeatures& features, Vec2 at) {
    features.x.push_back(at.x);
    features.y.push_back(at.y);
}

void addShape(GridFeatures& features, PlacedShape const& placed) {
    auto const [low, high] = extentOf(placed);
    addPoint(features, low);
    addPoint(features, high);
    for (ShapePiece const& piece : placed.shape.pieces) {
        for (Vec2 const corner : straightCornersOf(piece)) {
            Vec2 const inObject = piece.at + rotated(corner, piece.angle);
            addPoint(features, placed.at + rotated(inObject, placed.angle));
        }
    }
}

void tidy(std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace

bool liesOnGrid(double value, double step) {
    return std::abs(value - onGridNearest(value, step)) < onGrid;
}

GridFeatures gridFeatures(GameData const& data, Json const& level, std::vector<std::string> const& names) {
    GridFeatures features;
    std::set<std::string> const wanted(names.begin(), names.end());
    Json const* const list = findList(level, "objects");
    for (std::size_t i = 0; list != nullptr && i < list->size() && features.x.size() < mostFeatures; ++i) {
        Json const& entry = (*list)[i];
        if (!wanted.contains(textOf(entry, "name"))) {
            continue;
        }
        addPoint(features, placeOf(entry));
        for (PropertySet const& piece : piecesOf(data, entry)) {
            Shape const* const shape = piece.find<Shape>();
            if (shape == nullptr || faultIn(*shape)) {
                continue;
            }
            auto const* const position = piece.find<Position>();
            auto const* const rotation = piece.find<Rotation>();
            addShape(features, PlacedShape{*shape, position == nullptr ? Vec2{} : position->value,
                                           rotation == nullptr ? 0 : rotation->angle});
        }
    }
    tidy(features.x);
    tidy(features.y);
    return features;
}

double wayOnGrid(std::vector<double> const& features, double way, double step) {
    bool const any = std::any_of(features.begin(), features.end(),
                                 [&](double feature) { return liesOnGrid(feature, step); });
    if (any || features.empty()) {
        return onGridNearest(way, step);
    }
    if (std::abs(way) < step / 2) {
        return 0;
    }
    double best = onGridNearest(way, step);
    double least = step;
    for (double const feature : features) {
        double const by = onGridNearest(feature + way, step) - feature;
        if (std::abs(by - way) < least) {
            least = std::abs(by - way);
            best = by;
        }
    }
    return best;
}

} // namespace trembler::edit
