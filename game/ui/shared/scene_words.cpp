#include "game/ui/shared/scene_words.hpp"

#include "game/ui/shared/texts.hpp"
#include "render/panels/world_label.hpp"

#include <string>

namespace trembler::ui {

using namespace render;

void drawSceneWords(Camera const& camera, World const& world, SceneView const& scene, double alpha,
                    bool names) {
    for (SceneLabel const& label : scene.labels(world, alpha)) {
        worldLabel(camera, label.at, std::string(label.text).c_str(),
                   {.colour = label.colour, .metresHigh = label.metresHigh});
    }
    if (!names) {
        return;
    }
    for (Facts const& facts : FactsReader(world).drawOrder()) {
        worldLabel(camera, scene.poseOf(world, facts.id, alpha).at,
                   shownName(world.store().nameOf(facts.id)).c_str(), {.look = LabelLook::Chip});
    }
}

} // namespace trembler::ui
