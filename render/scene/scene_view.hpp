// The whole world as the player sees it.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/pick.hpp"
#include "render/scene/wires.hpp"

namespace trembler::render {

struct SceneOptions {
    double time = 0;     ///< s, moves the beads of current; no other effect
    double alpha = 1;    ///< share of the way from the frame before to the present one (SceneView only)
    ObjectId selected{}; ///< invalid: none
    ObjectId hovered{};
};

/// Draws a world. Holds what drawing must remember from frame to frame, and nothing of the world itself.
class SceneView {
public:
    /// Call it when a world begins (also again): forgets the old one.
    void start(World const& world);
    /// Call it directly before each World::step.
    void remember(World const& world);
    /// Between Canvas::begin and end; Canvas::paper is the caller's. Never changes the world.
    void draw(Canvas& canvas, World const& world, SceneOptions const& options = {}) const;
    /// Where the object is drawn.
    [[nodiscard]] Pose poseOf(World const& world, ObjectId id, double alpha = 1) const;

private:
    Poses poses_;
};

/// The same for a single picture.
void drawScene(Canvas& canvas, World const& world, SceneOptions const& options = {});

} // namespace trembler::render
