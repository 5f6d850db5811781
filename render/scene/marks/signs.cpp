#include "render/scene/marks/signs.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace trembler::render {
namespace {

void stroke(Canvas& canvas, Pose const& pose, double radius, std::vector<Point> points, Stroke const& look) {
    for (Point& point : points) {
        point = toWorld(pose, radius * point);
    }
    canvas.polyline(points, look);
}

} // namespace

void drawSign(Canvas& canvas, Sign sign, Pose const& pose, double radius, Colour colour, float alpha) {
    Stroke const look{.colour = colour, .width = 0.22 * radius, .alpha = alpha};
    switch (sign) {
    case Sign::plus:
        stroke(canvas, pose, radius, {{-0.58, 0}, {0.58, 0}}, look);
        stroke(canvas, pose, radius, {{0, -0.58}, {0, 0.58}}, look);
        break;
    case Sign::minus:
        stroke(canvas, pose, radius, {{-0.58, 0}, {0.58, 0}}, look);
        break;
    case Sign::earth:
        stroke(canvas, pose, radius, {{0, 0.68}, {0, 0.08}}, look);
        stroke(canvas, pose, radius, {{-0.62, 0.08}, {0.62, 0.08}}, look);
        stroke(canvas, pose, radius, {{-0.38, -0.25}, {0.38, -0.25}}, look);
        stroke(canvas, pose, radius, {{-0.14, -0.58}, {0.14, -0.58}}, look);
        break;
    case Sign::flash: {
        std::array<Point, 6> corners{Point{0.18, 0.75},   Point{-0.42, -0.12}, Point{-0.04, -0.12},
                                     Point{-0.18, -0.75}, Point{0.42, 0.14},   Point{0.04, 0.14}};
        for (Point& corner : corners) {
            corner = radius * corner;
        }
        canvas.polygon(pose, corners, {.tint = colour, .outline = 0.F, .alpha = alpha, .height = 0.F});
        break;
    }
    case Sign::north:
        stroke(canvas, pose, radius, {{-0.42, -0.6}, {-0.42, 0.6}, {0.42, -0.6}, {0.42, 0.6}}, look);
        break;
    case Sign::south: {
        // The upper bow anticlockwise from its right end down to the middle, the lower one on from there
        // clockwise.
        constexpr double quarter = 0.5 * std::numbers::pi;
        constexpr double end = 0.5; // rad, how far the bows' ends stand off the horizontal
        constexpr double sweep = 3 * quarter - end;
        std::vector<Point> bow;
        for (int i = 0; i <= 12; ++i) {
            double const angle = end + sweep * i / 12;
            bow.push_back({0.4 * std::cos(angle), 0.3 + 0.3 * std::sin(angle)});
        }
        for (int i = 1; i <= 12; ++i) {
            double const angle = quarter - sweep * i / 12;
            bow.push_back({0.4 * std::cos(angle), -0.3 + 0.3 * std::sin(angle)});
        }
        stroke(canvas, pose, radius, bow, look);
        break;
    }
    }
}

void drawBadge(Canvas& canvas, std::optional<Sign> sign, Pose const& pose, double radius, bool live,
               Style const& style) {
    Style disc = style;
    disc.pattern = Pattern::Plain;
    disc.tint = live ? mix(palette::live, palette::paperLight, 0.35F) : palette::paperLight;
    disc.outline = 1.8F;
    disc.height = 0.5F;
    disc.glow = {};
    if (live) {
        disc.glow = {palette::live, 0.6 * radius, 0.6F};
    }
    canvas.circle(pose, radius, disc);
    if (sign) {
        drawSign(canvas, *sign, pose, 0.82 * radius, palette::ink, style.ghost ? 0.6F : 1.F);
    }
}

} // namespace trembler::render
