// Words on the sheet: the labels that objects carry, and their names if the player asks for them.
#pragma once

#include "render/scene/scene_view.hpp"

namespace trembler::ui {

/// Between Gui::beginFrame and endFrame; objects are where `scene` draws them.
void drawSceneWords(render::Camera const& camera, World const& world, render::SceneView const& scene,
                    double alpha, bool names);

} // namespace trembler::ui
