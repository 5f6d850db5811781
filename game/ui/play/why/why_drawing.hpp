// The step of an answer that is looked at, drawn over the scene.
#pragma once

#include "game/ui/play/why/why_panel.hpp"
#include "render/draw/canvas.hpp"
#include "render/scene/facts/shape_geometry.hpp"

#include <vector>

namespace trembler::ui {

/// The objects in `world` of the step that is looked at; of a miss, the objects that the miss is about.
[[nodiscard]] std::vector<ObjectId> objectsOfStep(WhyPanel const& panel, World const& world);
/// Around each gap and each distance that the answer shows was missing, m.
[[nodiscard]] std::vector<render::Extent> gapsOfMiss(WhyPanel const& panel);
/// Rings where the steps happened, with arrows from causes to effects; of a miss, dashed lines along the
/// missing distances. Before Canvas::end.
void drawWhy(render::Canvas& canvas, WhyPanel const& panel);
/// The numbers of the steps, and the missing quantities. Between Gui::beginFrame and endFrame.
void drawWhyWords(render::Camera const& camera, double uiScale, WhyPanel const& panel);

} // namespace trembler::ui
