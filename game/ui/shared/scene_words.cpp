#include "game/ui/shared/scene_words.hpp"

#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "insight/miss/current/short_circuits.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/name_places.hpp"
#include "render/panels/theme.hpp"
#include "render/panels/world_label.hpp"
#include "render/scene/facts/shape_geometry.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace trembler::ui {

using namespace render;

namespace {

/// A line from a name to its object, where it does not stand on it.
void drawNameLine(NamedBox const& box, Point place) {
    Point const middle = 0.5 * (box.low + box.high);
    Point const half = 0.5 * box.size;
    Point const end{std::clamp(middle.x, place.x - half.x, place.x + half.x),
                    std::clamp(middle.y, place.y - half.y, place.y + half.y)};
    auto const corner = [](Point p) { return ImVec2(static_cast<float>(p.x), static_cast<float>(p.y)); };
    ImGui::GetBackgroundDrawList()->AddLine(corner(end), corner(middle), imColour(faded(palette::ink, 0.55F)),
                                            scaled(1.2F));
}

void drawNames(Camera const& camera, World const& world, SceneView const& scene, double alpha) {
    std::vector<std::string> names;
    std::vector<NamedBox> boxes;
    for (Facts const& facts : FactsReader(world).drawOrder()) {
        Pose const pose = scene.poseOf(world, facts.id, alpha);
        Point const at = camera.toScreen(pose.at);
        if (!finite(at)) {
            continue;
        }
        Extent const extent = facts.shape == nullptr ? Extent{} : extentOf(*facts.shape, pose);
        Point const half = extent.empty() ? Point{} : camera.pixelsPerMetre * extent.half();
        Point const middle = extent.empty() ? at : camera.toScreen(extent.centre());
        std::string name = shownName(world.store().nameOf(facts.id));
        boxes.push_back({middle - half, middle + half, chipSize(name.c_str())});
        names.push_back(std::move(name));
    }
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    std::vector<Point> const places = namePlaces(boxes, {screen.x, screen.y});
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        drawNameLine(boxes[i], places[i]);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        worldLabel(camera, camera.toWorld(places[i]), names[i].c_str(), {.look = LabelLook::Chip});
    }
}

/// A mark at each short-circuited source: nothing else there shows why its devices are dark.
void drawShortCircuits(Camera const& camera, World const& world, SceneView const& scene, double alpha) {
    constexpr float below = 26; // pixels at UI scale 1: beside the source, not on it
    for (ObjectId const source : insight::shortCircuits(world)) {
        worldLabel(camera, scene.poseOf(world, source, alpha).at, words::capital(words::shortCircuit).c_str(),
                   {.look = LabelLook::Chip, .colour = palette::warning, .below = below});
    }
}

} // namespace

void drawSceneWords(Camera const& camera, World const& world, SceneView const& scene, double alpha,
                    bool names) {
    for (SceneLabel const& label : scene.labels(world, alpha)) {
        worldLabel(camera, label.at, std::string(label.text).c_str(),
                   {.colour = label.colour, .metresHigh = label.metresHigh});
    }
    if (names) {
        drawNames(camera, world, scene, alpha);
    }
    drawShortCircuits(camera, world, scene, alpha);
}

} // namespace trembler::ui
