#include "render/scene/objects/device.hpp"

#include "render/scene/facts/look_form.hpp"
#include "render/scene/facts/shape_geometry.hpp"
#include "render/scene/marks/signs.hpp"
#include "render/scene/objects/body.hpp"
#include "render/scene/objects/compound.hpp"
#include "render/scene/objects/magnet.hpp"
#include "render/scene/objects/winding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace trembler::render {
namespace {

constexpr Colour socketBrass = rgb(0xC9A860);

bool hasPoles(Facts const& facts) {
    return facts.poles != nullptr && facts.poles->poles != PoleSet::none;
}

void drawFilament(Canvas& canvas, ShapePiece const& glass, Pose const& pose, bool on) {
    Extent const own = extentOf(glass, {});
    double const size = std::min(own.half().x, own.half().y);
    std::vector<Point> path{{-0.3, -0.9}, {-0.38, 0.1}};
    for (int i = 0; i < 6; ++i) {
        path.push_back({-0.3 + 0.12 * i, i % 2 == 0 ? 0.3 : 0.02});
    }
    path.push_back({0.38, 0.1});
    path.push_back({0.3, -0.9});
    for (Point& point : path) {
        point = toWorld(pose, own.centre() + size * point);
    }
    Stroke wire{.colour = on ? palette::liveCore : palette::ink, .width = 0.07 * size, .pixels = 1.5F};
    if (on) {
        wire.glow = {palette::live, 0.6 * size, 0.9F};
    }
    canvas.polyline(path, wire);
}

// Screws at the ends of long pieces and in the middle of others: fixed metal is bolted down.
void drawBolts(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style) {
    for (ShapePiece const& piece : facts.shape->pieces) {
        if (piece.form != ShapeForm::box || std::min(piece.width, piece.height) < 0.1) {
            continue; // there is no room, or the piece is not a plate
        }
        ShapePiece upright = piece;
        upright.at = {};
        upright.angle = 0;
        Extent const own = extentOf(upright, {});
        Point const half = own.half();
        double const small = std::min(half.x, half.y);
        double const radius = std::min(0.3 * small, 0.04);
        double const away = std::max(half.x, half.y) - 1.0 * std::max(small, 2.2 * radius);
        bool const two = away > 1.5 * small;
        Pose const inWorld{toWorld(pose, toPoint(piece.at)), pose.angle + piece.angle};
        for (double const side : {-1.0, 1.0}) {
            Point const offset = two ? side * away * (half.x >= half.y ? Point{1, 0} : Point{0, 1}) : Point{};
            Point const at = toWorld(inWorld, own.centre() + offset);
            Style screw = style;
            screw.pattern = Pattern::Metal;
            screw.tint = mix(palette::steel, palette::ink, 0.35F);
            screw.outline = 1.F;
            screw.height = 0.25F;
            screw.selected = false;
            screw.glow = {};
            canvas.circle({at, 0}, radius, screw);
            double const slot = inWorld.angle + 0.7 * side;
            Point const along = 0.62 * radius * Point{std::cos(slot), std::sin(slot)};
            canvas.line(at - along, at + along,
                        {.colour = palette::ink, .width = 0.28 * radius, .alpha = 0.75F});
            if (!two) {
                break;
            }
        }
    }
}

void drawBadges(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style) {
    bool const body = facts.shape != nullptr;
    Point const middle = body ? extentOf(*facts.shape, {}).centre() : Point{};
    Point const half = body ? extentOf(*facts.shape, {}).half() : Point{symbolRadius, symbolRadius};
    double const radius = body ? std::min(0.7 * std::min(half.x, half.y), 0.2) : symbolRadius;
    auto const badge = [&](std::optional<Sign> sign, Point offset) {
        Pose const at{toWorld(pose, middle + offset), body ? pose.angle : 0.0};
        drawBadge(canvas, sign, at, radius, facts.on, style);
    };
    switch (formOf(facts)) {
    case LookForm::battery: { // both of its ends on one body
        Point const apart = half.x >= half.y ? Point{0.5 * half.x, 0} : Point{0, 0.5 * half.y};
        badge(Sign::plus, apart);
        badge(Sign::minus, -1.0 * apart);
        break;
    }
    case LookForm::plus:
        badge(Sign::plus, {});
        break;
    case LookForm::minus:
        badge(Sign::minus, {});
        break;
    case LookForm::earth:
        badge(Sign::earth, {});
        break;
    case LookForm::flash:
        badge(signUnderLabel(facts, Sign::flash), {});
        break;
    case LookForm::own:
    case LookForm::plain:
    case LookForm::bulb:
        if (!body && facts.conductor) {
            canvas.circle(pose, 0.4 * symbolRadius, style);
        }
    }
}

} // namespace

void drawBulb(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style) {
    ShapePiece const& glass = largestPiece(*facts.shape);
    Shape socket;
    for (ShapePiece const& piece : facts.shape->pieces) {
        if (&piece != &glass) {
            socket.pieces.push_back(piece);
        }
    }
    Style metal = style;
    metal.pattern = Pattern::Metal;
    metal.tint = socketBrass;
    metal.glow = {};
    if (!socket.pieces.empty()) {
        drawShape(canvas, socket, pose, metal);
    }
    Facts ofGlass = facts;
    ofGlass.substance = Substance::glass; // whatever the object is made of
    Style bulb = style;
    bulb.pattern = styleOf(ofGlass).pattern;
    bulb.tint = styleOf(ofGlass).tint;
    if (facts.on) {
        bulb.tint = Colour{palette::liveCore.red, palette::liveCore.green, palette::liveCore.blue, 215};
    }
    drawShape(canvas, Shape{{glass}}, pose, bulb);
    drawFilament(canvas, glass, pose, facts.on);
}

Glow deviceGlow(Facts const& facts) {
    double const size = innerSize(facts);
    double const level = facts.coil != nullptr ? std::clamp(facts.magnetLevel(), 0.0, 1.0) : 0.0;
    if (level > 0) {
        return {palette::live, 0.25 + 0.6 * size, static_cast<float>(0.55 * level)};
    }
    if (!facts.on) {
        return {};
    }
    if (formOf(facts) == LookForm::bulb) {
        return {palette::live, 0.3 + 2.5 * size, 0.75F};
    }
    return {palette::live, facts.device ? 0.1 + 0.6 * size : 0.09, facts.device ? 0.7F : 0.6F};
}

void drawDevice(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style) {
    bool const body = facts.shape != nullptr && !facts.shape->pieces.empty();
    if (body && facts.coil != nullptr) {
        drawWinding(canvas, facts, pose, style);
    } else if (body && hasPoles(facts)) {
        drawMagnet(canvas, facts, pose, style);
    }
    if (body && facts.fixed && isMetal(facts.substance) && facts.coil == nullptr && !hasPoles(facts) &&
        formOf(facts) == LookForm::plain) {
        drawBolts(canvas, facts, pose, style);
    }
    drawBadges(canvas, facts, pose, style);
}

Point terminalOf(Facts const& facts, Pose const& pose, Point towards) {
    if (facts.shape == nullptr || facts.shape->pieces.empty()) {
        Point const d = towards - pose.at;
        double const reach = length(d);
        return reach > 0 ? pose.at + (0.85 * symbolRadius / reach) * d : pose.at;
    }
    if (facts.coil != nullptr) {
        Winding const winding = windingOf(facts);
        Point const a = toWorld(pose, winding.terminals[0]);
        Point const b = toWorld(pose, winding.terminals[1]);
        return length(a - towards) <= length(b - towards) ? a : b;
    }
    Point const edge = nearestOnEdge(*facts.shape, toLocal(pose, towards));
    Point const inwards = centroidOf(*facts.shape) - edge;
    double const depth = std::min(0.45 * innerSize(facts), 0.06);
    double const reach = length(inwards);
    return toWorld(pose, reach > depth ? edge + (depth / reach) * inwards : edge);
}

} // namespace trembler::render
