#include "render/scene/objects/drawing.hpp"

#include "physics/drawing_palette.hpp"
#include "render/scene/facts/drawn_copies.hpp"
#include "render/scene/facts/look_form.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace trembler::render {
namespace {

constexpr float glowStrength = 0.75F;

std::optional<Colour> statedColour(std::string const& text) {
    std::optional<std::uint32_t> const value = colourInDrawing(text);
    if (!value) {
        return std::nullopt;
    }
    Colour colour = rgb(*value >> 8U);
    colour.alpha = static_cast<std::uint8_t>(*value & 0xFFU);
    return colour;
}

Glow glowOf(DrawnShape const& shape) {
    if (!(shape.glow > 0)) {
        return {};
    }
    return {statedColour(shape.glowColour).value_or(palette::live), shape.glow, glowStrength};
}

// Draws the shapes of one object.
class ShapePainter {
public:
    ShapePainter(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& body)
        : canvas_(canvas), pose_(pose), body_(body), strength_(body.ghost && !body.forbidden ? 0.55F : 1.F) {
        bodyColour_ = body.tint.value_or(colourOf(body.pattern));
        hiddenBody_ = !facts.drawing->body;
    }

    // One outline around all copies of all these shapes: first all rims, then all insides.
    void joined(std::span<DrawnShape const> run, Facts const& facts) const {
        for (Layer const layer : {Layer::Rim, Layer::Inside}) {
            for (DrawnShape const& shape : run) {
                if (isShown(shape.when, facts)) {
                    copies(shape, layer);
                }
            }
        }
    }
    void copies(DrawnShape const& shape, Layer layer) const {
        if (reachOf(shape) < canvas_.metres(0.35)) {
            return; // it would not be seen
        }
        for (std::int32_t copy = 0; copy < shape.repeat; ++copy) {
            Pose const own = poseOfCopy(shape, copy);
            Pose const at{toWorld(pose_, own.at), pose_.angle + own.angle};
            shape.isArea() ? area(shape, at, layer) : line(shape, at);
        }
    }

private:
    [[nodiscard]] Style styleOfArea(DrawnShape const& shape, double small, Layer layer) const {
        Style style;
        std::optional<Colour> usual;
        if (shape.pattern == DrawnPattern::own) {
            style = body_;
            style.selected = false;
            usual = bodyColour_;
        } else if (shape.pattern == DrawnPattern::plain) {
            usual = bodyColour_;
        } else {
            // The materials follow `plain` and `own`, in their own order.
            style = styleOf(static_cast<Substance>(static_cast<int>(shape.pattern) - 2));
            usual = style.tint;
        }
        std::optional<Colour> tint = statedColour(shape.colour);
        if (tint && shape.pattern != DrawnPattern::plain && shape.colour.size() != 9 && tint->alpha == 255) {
            tint->alpha = usual.value_or(colourOf(style.pattern)).alpha; // coloured glass stays translucent
        }
        style.tint = tint ? tint : usual;
        style.flat = shape.shading == DrawnShading::flat;
        style.alpha = static_cast<float>(shape.opacity) * strength_;
        style.height = body_.ghost ? 0.F : static_cast<float>(shape.raised);
        style.onBody = true;
        style.glow = glowOf(shape);
        style.layer = layer;
        // An outline must not cover a small shape when it is far away.
        double const pixels = shape.outline < 0 ? 1.0 : shape.outline;
        style.outline = static_cast<float>(std::min(pixels, 0.3 * small / canvas_.metres(1)));
        style.outlineColour = statedColour(shape.outlineColour);
        style.hovered = body_.hovered;
        style.forbidden = body_.forbidden && hiddenBody_;
        style.ghost = false;
        return style;
    }

    void area(DrawnShape const& shape, Pose const& at, Layer layer) const {
        switch (shape.form) {
        case DrawnForm::box: {
            // Grain runs along the longer side, as on bodies.
            Point half{0.5 * shape.width, 0.5 * shape.height};
            Pose pose = at;
            if (half.y > half.x) {
                std::swap(half.x, half.y);
                pose.angle += 0.5 * std::numbers::pi;
            }
            canvas_.box(pose, half, shape.corner, styleOfArea(shape, half.y, layer));
            break;
        }
        case DrawnForm::circle:
            canvas_.circle(at, shape.radius, styleOfArea(shape, shape.radius, layer));
            break;
        case DrawnForm::capsule: {
            double const along = std::max(0.0, 0.5 * shape.width - shape.radius);
            canvas_.capsule(toWorld(at, {-along, 0}), toWorld(at, {along, 0}), shape.radius,
                            styleOfArea(shape, shape.radius, layer));
            break;
        }
        default: {
            std::vector<Point> corners;
            Point lower{1e9, 1e9};
            Point upper{-1e9, -1e9};
            for (Vec2 const corner : shape.corners) {
                corners.push_back({corner.x, corner.y});
                lower = {std::min(lower.x, corner.x), std::min(lower.y, corner.y)};
                upper = {std::max(upper.x, corner.x), std::max(upper.y, corner.y)};
            }
            double const small = 0.5 * std::min(upper.x - lower.x, upper.y - lower.y);
            canvas_.polygon(at, corners, styleOfArea(shape, small, layer));
            break;
        }
        }
    }

    void line(DrawnShape const& shape, Pose const& at) const {
        Colour const colour = body_.forbidden && hiddenBody_
                                  ? palette::warning
                                  : statedColour(shape.colour).value_or(palette::ink);
        double const pixels = std::max(0.0, shape.outline);
        Stroke stroke{.colour = colour,
                      .width = shape.thickness,
                      .outline =
                          static_cast<float>(std::min(pixels, 0.3 * shape.thickness / canvas_.metres(1))),
                      .outlineColour = statedColour(shape.outlineColour).value_or(palette::ink),
                      .alpha = static_cast<float>(shape.opacity) * strength_,
                      .round = shape.shading == DrawnShading::round,
                      .height = body_.ghost ? 0.F : static_cast<float>(shape.raised),
                      .onBody = true,
                      .glow = glowOf(shape)};
        if (shape.form == DrawnForm::line) {
            std::vector<Point> path = pathOf(shape);
            for (Point& point : path) {
                point = toWorld(at, point);
            }
            canvas_.polyline(path, stroke);
        } else if (shape.form == DrawnForm::ring) {
            canvas_.ring(at.at, shape.radius, stroke);
        } else {
            double const middle = at.angle + 0.5 * std::numbers::pi;
            canvas_.arc(at.at, shape.radius, middle - 0.5 * shape.sweep, shape.sweep, stroke);
        }
    }

    Canvas& canvas_;
    Pose pose_;
    Style body_;
    float strength_;
    Colour bodyColour_{};
    bool hiddenBody_ = false;
};

} // namespace

void drawShapes(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style) {
    ShapePainter const painter(canvas, facts, pose, style);
    std::vector<DrawnShape> const& shapes = facts.drawing->shapes;
    for (std::size_t first = 0; first < shapes.size();) {
        std::size_t end = first + 1;
        while (end < shapes.size() && shapes[end].joined) {
            ++end;
        }
        if (end > first + 1) {
            painter.joined(std::span(shapes).subspan(first, end - first), facts);
        } else if (isShown(shapes[first].when, facts)) {
            painter.copies(shapes[first], Layer::Whole);
        }
        first = end;
    }
}

} // namespace trembler::render
