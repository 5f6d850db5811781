#include "render/scene/objects/ties.hpp"

#include "render/draw/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace trembler::render {
namespace {

constexpr Colour ropeTint = rgb(0xB79B6C);
constexpr Colour beltTint = rgb(0x45434A);
constexpr double linkPitch = 0.075; // m, from one link of a chain to the next
constexpr double beltPitch = 0.12;  // m, between a belt's marks
constexpr double mostLinks = 600;
constexpr int piecesAround = 24; // of a belt around a wheel

Stroke strokeOf(JointDrawn look) {
    Stroke stroke{
        .colour = ropeTint, .width = 0.035, .pixels = 2.2F, .outline = 1.1F, .round = true, .height = 0.7F};
    switch (look) {
    case JointDrawn::cord:
        stroke.colour = mix(ropeTint, palette::ink, 0.45F);
        stroke.width = 0.014;
        stroke.pixels = 1.4F;
        stroke.outline = 0.F;
        stroke.round = false;
        break;
    case JointDrawn::wire:
        stroke.colour = palette::copper;
        stroke.width = 0.026;
        break;
    case JointDrawn::rod:
        stroke.colour = mix(palette::steel, palette::ink, 0.15F);
        stroke.width = 0.045;
        stroke.pixels = 2.5F;
        stroke.outline = 1.3F;
        break;
    case JointDrawn::belt:
        stroke.colour = beltTint;
        stroke.width = 0.04;
        stroke.pixels = 2.5F;
        stroke.round = false;
        break;
    default:
        break;
    }
    return stroke;
}

// The strands of a rope, where they can be seen.
void drawStrands(Canvas& canvas, std::span<Point const> path) {
    double const total = pathLength(path);
    double const pitch = std::max(0.05, total / mostLinks);
    if (pitch < canvas.metres(5)) {
        return;
    }
    Stroke const strand{.colour = mix(ropeTint, palette::ink, 0.5F), .width = 0.006, .alpha = 0.55F};
    for (double at = 0.5 * pitch; at < total; at += pitch) {
        Point const from = pointAlong(path, at - 0.013);
        Point const along = pointAlong(path, at + 0.013) - from;
        double const span = length(along);
        if (span > 0) {
            Point const across = (0.009 / span) * Point{-along.y, along.x};
            canvas.line(from + across, from + along - across, strand);
        }
    }
}

// Every second link is seen from its edge.
void drawLinks(Canvas& canvas, std::span<Point const> path, double moved) {
    double const total = pathLength(path);
    double const pitch = std::max(linkPitch, total / mostLinks);
    Style flat{.pattern = Pattern::Metal, .outline = 1.F, .height = 0.5F};
    Style edge = flat;
    edge.tint = mix(palette::steel, palette::ink, 0.35F);
    Style const hole{
        .tint = mix(palette::steel, palette::ink, 0.8F), .outline = 0.F, .height = 0.F, .flat = true};
    double const turns = moved / (2 * pitch);
    double const first = 2 * pitch * (turns - std::floor(turns)) - 2 * pitch;
    auto const draw = [&](int parity) {
        int link = 0;
        for (double at = first; at < total; at += pitch, ++link) {
            double const from = std::max(0.0, at);
            double const to = std::min(total, at + pitch);
            if (link % 2 != parity || to - from < 0.3 * pitch) {
                continue;
            }
            Point const a = pointAlong(path, from);
            Point const b = pointAlong(path, to);
            if (parity == 0) {
                canvas.capsule(a, b, 0.3 * pitch, flat);
                canvas.capsule(a + 0.12 * (b - a), b - 0.12 * (b - a), 0.12 * pitch, hole);
            } else {
                canvas.capsule(a, b, 0.16 * pitch, edge);
            }
        }
    };
    draw(0);
    draw(1);
}

void drawBeltMarks(Canvas& canvas, std::span<Point const> path, double moved) {
    canvas.beads(path, beltPitch, moved / beltPitch, 0.008, mix(beltTint, palette::paper, 0.55F));
}

} // namespace

void drawTie(Canvas& canvas, JointDrawn look, std::span<Point const> path, double moved) {
    if (path.size() < 2 || look == JointDrawn::own || look == JointDrawn::none) {
        return;
    }
    if (look == JointDrawn::spring) {
        drawCoil(canvas, path.front(), path.back(), pathLength(path));
        return;
    }
    if (look == JointDrawn::chain) {
        drawLinks(canvas, path, moved);
        return;
    }
    canvas.polyline(path, strokeOf(look));
    if (look == JointDrawn::rope) {
        drawStrands(canvas, path);
    } else if (look == JointDrawn::belt) {
        drawBeltMarks(canvas, path, moved);
    }
}

void drawCoil(Canvas& canvas, Point a, Point b, double rest) {
    double const usual = rest > 0 ? rest : length(b - a);
    int const turns = std::clamp(static_cast<int>(std::lround(usual / 0.075)), 4, 28);
    std::vector<Point> const path = coil(a, b, std::clamp(0.12 * usual, 0.04, 0.11), turns);
    Stroke wire{
        .colour = mix(palette::steel, palette::ink, 0.45F), .width = 0.02, .pixels = 1.6F, .outline = 0.9F};
    if (path.size() < 5) {
        canvas.polyline(path, wire);
        return;
    }
    // First the far half of each turn; over it the near half, which is lighter.
    auto const half = [&](std::size_t i) { canvas.line(path[i], path[i + 1], wire); };
    for (std::size_t i = 2; i + 3 < path.size(); i += 2) {
        half(i + 1);
    }
    wire.colour = mix(palette::steel, rgb(0xFFFFFF), 0.15F);
    wire.width = 0.026;
    wire.pixels = 2.2F;
    wire.height = 0.6F;
    wire.round = true;
    std::array const start{path[0], path[1], path[2]};
    std::array const finish{path[path.size() - 3], path[path.size() - 2], path[path.size() - 1]};
    canvas.polyline(start, wire);
    canvas.polyline(finish, wire);
    for (std::size_t i = 2; i + 3 < path.size(); i += 2) {
        half(i);
    }
}

std::vector<Point> beltPath(BeltWheel const& first, BeltWheel const& second, bool crossed) {
    constexpr double full = 2 * std::numbers::pi;
    Point const apart = second.centre - first.centre;
    double const distance = length(apart);
    double const lever = crossed ? first.radius + second.radius : first.radius - second.radius;
    if (!(first.radius > 0) || !(second.radius > 0) || !(distance > std::abs(lever))) {
        return {};
    }
    double const line = std::atan2(apart.y, apart.x);
    double const off =
        std::acos(lever / distance); // of the points where the belt leaves a wheel, from the line
    std::vector<Point> path;
    auto const around = [&](BeltWheel const& wheel, double from, double to) {
        for (int i = 0; i <= piecesAround; ++i) {
            double const angle = from + (to - from) * i / piecesAround;
            path.push_back(wheel.centre + wheel.radius * Point{std::cos(angle), std::sin(angle)});
        }
    };
    around(first, line + off, line + full - off);
    if (crossed) {
        around(second, line + 0.5 * full - off, line - 0.5 * full + off);
    } else {
        around(second, line - off, line + off);
    }
    path.push_back(path.front());
    return path;
}

} // namespace trembler::render
