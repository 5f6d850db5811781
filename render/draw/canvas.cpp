// The canvas' frame and its filled shapes; lines are in canvas_lines.cpp.
#include "render/draw/canvas.hpp"

#include "render/draw/narrow.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::render {

namespace {

constexpr std::size_t mostCorners = 64;
/// Shadows fall to the lower right, away from the shaders' light.
constexpr Point shadowDirection{0.5, -0.866};

std::uint8_t flagsOf(Style const& style) {
    unsigned flags = 0;
    flags |= style.selected && style.layer != Layer::Inside ? flagSelected : 0U;
    flags |= style.ghost ? flagGhost : 0U;
    flags |= style.forbidden ? flagForbidden : 0U;
    flags |= style.hovered ? flagHovered : 0U;
    flags |= style.layer == Layer::Rim ? flagRim : 0U;
    flags |= style.layer == Layer::Inside ? flagInside : 0U;
    return static_cast<std::uint8_t>(flags);
}

} // namespace

Canvas::Canvas() = default;

void Canvas::begin(Camera const& camera, CanvasOptions const& options) {
    camera_ = camera;
    options_ = options;
    done_.clear();
    shadows_.clear();
    shapes_.clear();
    corners_.clear();
    flattens_ = false;
}

void Canvas::paper() {
    paper_.draw(camera_, options_.uiScale);
}

void Canvas::newSheet() {
    done_.insert(done_.end(), shadows_.begin(), shadows_.end());
    done_.insert(done_.end(), shapes_.begin(), shapes_.end());
    shadows_.clear();
    shapes_.clear();
}

void Canvas::end() {
    newSheet();
    double const scale = camera_.pixelsPerMetre;
    batch_.draw(done_, corners_,
                {narrow(0.5 * camera_.viewport.width / scale),
                 narrow(0.5 * camera_.viewport.height / scale),
                 narrow(1 / scale),
                 options_.uiScale,
                 narrow(std::fmod(options_.time, 3600.0)),
                 relative(options_.flattening.about),
                 {narrow(options_.flattening.x), narrow(options_.flattening.y)}});
    sent_ = done_.size();
}

double Canvas::metres(double pixels) const {
    return pixels * static_cast<double>(options_.uiScale) / camera_.pixelsPerMetre;
}

Corner Canvas::relative(Point world) const {
    return {narrow(world.x - camera_.centre.x), narrow(world.y - camera_.centre.y)};
}

Instance Canvas::placed(Point at, double angle, Point half) const {
    Instance shape;
    shape.centre = relative(at);
    shape.axis = {narrow(std::cos(angle)), narrow(std::sin(angle))};
    shape.half = {narrow(half.x), narrow(half.y)};
    return shape;
}

bool Canvas::seen(Instance const& shape, double margin) const {
    double const reach = std::hypot(shape.half[0], shape.half[1]) + margin;
    double const right = 0.5 * camera_.viewport.width / camera_.pixelsPerMetre + reach;
    double const top = 0.5 * camera_.viewport.height / camera_.pixelsPerMetre + reach;
    // Written so that a shape with a number that is not finite counts as not seen.
    return std::abs(shape.centre[0]) <= right && std::abs(shape.centre[1]) <= top && std::isfinite(reach) &&
           std::isfinite(shape.axis[0]) && shape.half[0] > 0 && shape.half[1] > 0;
}

void Canvas::push(Instance const& shape) {
    shapes_.push_back(shape);
    if (flattens_) {
        shapes_.back().flags = static_cast<std::uint8_t>(shapes_.back().flags | flagFlattened);
    }
}

void Canvas::addShadow(Instance shape, float height, float alpha, bool onBody) {
    if (!options_.shadows || !(height > 0.F)) {
        return;
    }
    // Small parts lie low: a shadow longer than its part looks like dirt.
    double const small = std::min(shape.half[0], shape.half[1]);
    double const distance = static_cast<double>(height) * std::min(metres(5), 0.6 * small + metres(1));
    shape.centre[0] += narrow(distance * shadowDirection.x);
    shape.centre[1] += narrow(distance * shadowDirection.y);
    shape.effect = effectShadow;
    shape.outline = narrow(1.3 * distance);
    shape.colour = packed(faded(palette::shadow, alpha));
    shape.flags = 0;
    (onBody ? shapes_ : shadows_).push_back(shape);
}

void Canvas::addGlow(Instance shape, Glow const& glow, float alpha) {
    if (!(glow.reach > 0) || !(glow.strength > 0.F) || !std::isfinite(glow.reach) ||
        !seen(shape, glow.reach)) {
        return;
    }
    shape.effect = effectGlow;
    shape.outline = narrow(glow.reach);
    shape.colour = packed(faded(glow.colour, glow.strength * alpha));
    shape.flags = 0;
    push(shape);
}

void Canvas::fill(Instance shape, Style const& style) {
    if (!seen(shape, metres(12)) && !(style.glow.reach > 0)) {
        return;
    }
    Colour const tint = style.tint.value_or(colourOf(style.pattern));
    if (style.layer != Layer::Inside) {
        if (!style.ghost) {
            // Translucent shapes cast little shadow.
            addShadow(shape, style.height, style.alpha * static_cast<float>(tint.alpha) / 255.F,
                      style.onBody);
        }
        addGlow(shape, style.glow, style.alpha);
    }
    if (!seen(shape, metres(12)) || (style.layer == Layer::Shadow && !style.selected)) {
        return;
    }
    if (style.layer == Layer::Shadow) {
        shape.flags = flagSelected;
        push(shape); // only the ring has a colour
        return;
    }
    Colour const opaque{tint.red, tint.green, tint.blue, 255};
    shape.colour = packed(faded(tint, style.alpha));
    shape.edge = packed(
        faded(style.outlineColour.value_or(mix(palette::ink, opaque, tint.alpha < 128 ? 0.45F : 0.20F)),
              style.alpha));
    shape.outline = narrow(metres(static_cast<double>(style.outline)));
    shape.effect = style.flat ? effectFlat : effectSolid;
    shape.pattern = static_cast<std::uint8_t>(style.pattern);
    shape.flags = flagsOf(style);
    shape.grain = style.grain > 0 ? narrow(style.grain) : std::min(shape.half[0], shape.half[1]);
    push(shape);
}

void Canvas::box(Pose const& pose, Point half, double cornerRadius, Style const& style) {
    auto shape = placed(pose.at, pose.angle, half);
    shape.radius = narrow(std::clamp(cornerRadius, 0.0, std::max(0.0, std::min(half.x, half.y))));
    fill(shape, style);
}

void Canvas::circle(Pose const& pose, double radius, Style const& style) {
    box(pose, {radius, radius}, radius, style);
}

void Canvas::capsule(Point a, Point b, double radius, Style const& style) {
    Point const along = b - a;
    box({0.5 * (a + b), std::atan2(along.y, along.x)}, {0.5 * length(along) + radius, radius}, radius, style);
}

void Canvas::polygon(Pose const& pose, std::span<Point const> corners, Style const& style) {
    if (corners.size() < 3 || corners.size() > mostCorners ||
        !std::all_of(corners.begin(), corners.end(), finite)) {
        return;
    }
    Point lower = corners.front();
    Point upper = lower;
    for (Point const corner : corners) {
        lower = {std::min(lower.x, corner.x), std::min(lower.y, corner.y)};
        upper = {std::max(upper.x, corner.x), std::max(upper.y, corner.y)};
    }
    // The quad is centred on the corners' box, whose middle need not be the body's own origin.
    Point const middle = 0.5 * (lower + upper);
    auto shape = placed(toWorld(pose, middle), pose.angle, 0.5 * (upper - lower));
    shape.kind = kindPolygon;
    shape.params = {static_cast<float>(corners_.size()), static_cast<float>(corners.size()), 0.F, 0.F};
    for (Point const corner : corners) {
        corners_.push_back({narrow(corner.x - middle.x), narrow(corner.y - middle.y)});
    }
    fill(shape, style);
}

void Canvas::glow(Point centre, double radius, Glow const& glow) {
    auto shape = placed(centre, 0, {radius, radius});
    shape.radius = narrow(radius);
    addGlow(shape, glow, 1.F);
}

} // namespace trembler::render
