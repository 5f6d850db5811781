// Text in the world: the labels of objects, their names if the player asks for them, and short circuits.
#pragma once

#include "render/scene/scene_view.hpp"

namespace trembler::ui {

/// Call between Gui::beginFrame and endFrame; uses the objects' positions in `scene`.
void drawSceneWords(render::Camera const& camera, World const& world, render::SceneView const& scene,
                    double alpha, bool names);

} // namespace trembler::ui
