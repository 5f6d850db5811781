// The whole world as the player sees it.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/areas.hpp"
#include "render/scene/facts/pick.hpp"
#include "render/scene/labels.hpp"
#include "render/scene/objects/wires.hpp"
#include "render/scene/overlays/overlay_hand.hpp"
#include "render/scene/overlays/overlay_sound.hpp"

#include <span>

namespace trembler::render {

/// The additions to the picture of the objects themselves; everything is off unless asked for.
struct Overlays {
    bool electricity = false; ///< the graph, its live parts lit
    bool forces = false;      ///< magnetic ones, and F_B at the centres of buoyancy
    bool fieldLines = false;  ///< of all magnets that act
    bool contacts = false;    ///< with normals and impulses under World::want<ContactPatches>()
};

struct SceneOptions {
    double time = 0;     ///< s, moves the beads of current; no other effect
    double alpha = 1;    ///< share of the way from the frame before to the present one (SceneView only)
    ObjectId selected{}; ///< invalid: none
    ObjectId hovered{};  ///< invalid: none
    ObjectId hidden{};   ///< its body is left out; invalid: none
    std::span<ObjectId const> alsoSelected{};
    std::span<ObjectId const> alsoHovered{};
    /// Bodies that are left out too, with the joints among them and the wires at their ends.
    std::span<ObjectId const> alsoHidden{};
    /// Objects that are drawn flattened, see Canvas::flatten.
    std::span<ObjectId const> flattened{};
    Overlays overlays{};
    std::span<Area const> placing{};     ///< where parts may be placed
    bool faintPlacing = false;           ///< those are only hinted at
    std::span<GoalRegion const> goals{}; ///< of goals
    std::span<Ripple const> ripples{};   ///< of sounding objects
    HandPlaces hands{};                  ///< where the hands are drawn
};

/// Draws a world. Holds the poses that drawing must remember from frame to frame, and nothing of the world
/// itself. Window thread only, while the world is not stepped; never changes it.
///
/// Per display frame: canvas.begin(camera); canvas.paper(); view.draw(canvas, world, ...); then the game's
/// own drawing on top (drawGhost); canvas.end(); and in the panels' pass a worldLabel() for each of
/// view.labels(...).
class SceneView {
public:
    /// Call it when a world begins or restarts: forgets the old one.
    void start() { poses_.forget(); }
    /// Call it directly before each World::step, where frames are to be drawn in between.
    void remember(World const& world) { poses_.remember(world); }
    void draw(Canvas& canvas, World const& world, SceneOptions const& options = {}) const;
    /// The words on the objects, at the places where draw() puts the objects.
    [[nodiscard]] std::vector<SceneLabel> labels(World const& world, double alpha = 1) const {
        return sceneLabels(world, poses_, alpha);
    }
    /// Where the object is drawn.
    [[nodiscard]] Pose poseOf(World const& world, ObjectId id, double alpha = 1) const;

private:
    Poses poses_;
};

/// The same for a single picture.
void drawScene(Canvas& canvas, World const& world, SceneOptions const& options = {});

} // namespace trembler::render
