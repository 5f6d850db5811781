// The electricity graph over the scene, as the thesis draws it into its screen-shots (Figure 6-3).
#pragma once

#include "render/scene/objects/wires.hpp"

namespace trembler::render {

/// Vertices with their part in a network (source, return, device), wires as solid lines, contacts as dashed
/// ones; objects with a current are lit and arrows show its direction.
void drawElectricity(Canvas& canvas, FactsReader const& reader, std::vector<Link> const& links,
                     PoseOf const& poseOf);

/// Lays thin paper over everything that was drawn before, so that a diagram on top is legible.
void drawVeil(Canvas& canvas, float alpha);

} // namespace trembler::render
