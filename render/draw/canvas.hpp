// Drawing in world metres: the shapes, lines and glows that every scene and overlay is made of.
#pragma once

#include "render/draw/camera.hpp"
#include "render/draw/instance.hpp"
#include "render/draw/paper.hpp"
#include "render/draw/shape_batch.hpp"
#include "render/draw/style.hpp"

#include <span>
#include <vector>

namespace trembler::render {

/// A deformation of shapes for a moment, as of a part that has just been put down: they are scaled about a
/// place.
struct Flattening {
    Point about; ///< m
    double x = 1;
    double y = 1;
};

struct CanvasOptions {
    float uiScale = 1.F;     ///< the factor on all lengths in pixels; take Window::uiScale
    double time = 0;         ///< s; moves water, nothing else
    bool shadows = true;     ///< leave them out on software OpenGL: they double the cost of a frame
    Flattening flattening{}; ///< of the shapes between flatten(true) and flatten(false)
};

/// Collects shapes between begin and end and draws them in that order, in few calls. Only soft shadows come
/// earlier: those of one sheet (see `newSheet`) lie under all of its shapes, so that touching parts do not
/// darken each other.
///
/// Positions and lengths are metres, angles radians. A shape with a number that is not finite, or without
/// extent, is left out, as is one outside the view: drawing never fails, whatever numbers the simulation
/// produces. Window thread only.
class Canvas {
public:
    /// Needs a current context (make the Window first). Throws RenderError if the driver does not take the
    /// shaders.
    Canvas();

    /// Starts a picture that fills the bound target; camera.viewport must be that target's size.
    void begin(Camera const& camera, CanvasOptions const& options = {});
    /// The paper and its grid over everything; call it first.
    void paper();
    /// Later shapes lie on top of all earlier ones, with shadows on them (a part that is being dragged).
    void newSheet();
    /// Whether shapes from now on are flattened by the Flattening in the picture's options; their shadows are
    /// not.
    void flatten(bool on) { flattens_ = on; }
    /// Draws the collected shapes. Throws RenderError if the driver refuses a shader that is needed for the
    /// first time.
    void end();

    /// Half extents; corners rounded by `cornerRadius` (within the extents, clamped to the smaller one).
    void box(Pose const& pose, Point half, double cornerRadius, Style const& style);
    /// The angle turns the pattern, too.
    void circle(Pose const& pose, double radius, Style const& style);
    /// All points within `radius` of the segment from a to b.
    void capsule(Point a, Point b, double radius, Style const& style);
    /// Corners (3 to 64, either way round, need not be convex) in the frame of `pose`; other numbers draw
    /// nothing.
    void polygon(Pose const& pose, std::span<Point const> corners, Style const& style);

    /// Straight pieces with round joints and ends. At least two points; fewer draw nothing.
    void polyline(std::span<Point const> points, Stroke const& stroke);
    void line(Point a, Point b, Stroke const& stroke);
    /// A circle's line; the stroke lies half inside and half outside of the radius.
    void ring(Point centre, double radius, Stroke const& stroke);
    /// From `from` on by `sweep` radians (anticlockwise if positive) with round ends.
    void arc(Point centre, double radius, double from, double sweep, Stroke const& stroke);
    /// Ends exactly at `to`. The head is about three times as wide as the line and shrinks with arrows
    /// shorter than itself.
    void arrow(Point from, Point to, Stroke const& stroke);
    /// Beads that move along a path: `phase` in beads (1 moves each to the place of the next), `spacing` in
    /// metres.
    void beads(std::span<Point const> path, double spacing, double phase, double radius, Colour colour);
    /// A disc of light that fades out between `radius` and radius + glow.reach.
    void glow(Point centre, double radius, Glow const& glow);

    [[nodiscard]] Camera const& camera() const { return camera_; }
    /// Metres that `pixels` at UI scale 1 are.
    [[nodiscard]] double metres(double pixels) const;
    /// How many shapes were sent by the last end(), shadows and glows included.
    [[nodiscard]] std::size_t drawn() const { return sent_; }

private:
    [[nodiscard]] Instance placed(Point at, double angle, Point half) const;
    [[nodiscard]] bool seen(Instance const& shape, double margin) const;
    [[nodiscard]] Corner relative(Point world) const;
    void fill(Instance shape, Style const& style);
    void strokeShape(Instance shape, Stroke const& stroke, double halfWidth);
    void addShadow(Instance shape, float height, float alpha, bool onBody);
    void addGlow(Instance shape, Glow const& glow, float alpha);
    void addSegments(std::span<Point const> points, double radius, Colour colour, Point shift);
    void addChain(std::span<Point const> points, Instance look, double radius, double reach, bool underSheet);
    [[nodiscard]] double halfWidth(Stroke const& stroke) const;
    void push(Instance const& shape);

    ShapeBatch batch_;
    Paper paper_;
    Camera camera_;
    CanvasOptions options_;
    std::vector<Instance> done_;    // sheets that are complete
    std::vector<Instance> shadows_; // of the current sheet
    std::vector<Instance> shapes_;
    std::vector<Corner> corners_;
    std::size_t sent_ = 0;
    bool flattens_ = false;
};

} // namespace trembler::render
