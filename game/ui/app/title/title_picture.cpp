#include "game/ui/app/title/title_picture.hpp"

#include "render/draw/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trembler::ui {

using namespace render;

namespace {

constexpr double ringing = 1.0; // s

/// Position of the armature. 0: at rest, the circuit is closed; 1: pulled over, the hammer touches the bell.
double pulled(double time) {
    double const phase = std::fmod(time, titlePeriod);
    return phase > ringing ? 0.0 : 0.5 - 0.5 * std::cos(phase * 2 * 3.14159265 * 6 / ringing);
}

void drawBell(Canvas& canvas, Point at, double struck) {
    double const shake = 0.012 * struck;
    Pose const pose{at + Point{shake, 0}, 0};
    canvas.circle(pose, 0.72, {.pattern = Pattern::Copper});
    canvas.circle(pose, 0.60, {.pattern = Pattern::Copper, .outline = 1.F, .height = 0});
    canvas.circle(pose, 0.10, {.pattern = Pattern::Metal, .height = 0.4F});
    for (int ring = 0; ring < 3; ++ring) {
        double const radius = 0.86 + 0.17 * ring;
        auto const alpha = static_cast<float>(std::max(struck * (0.55 - 0.15 * ring), 0.0));
        if (alpha > 0.02F) {
            canvas.arc(at, radius, 0.15, 1.0, {.colour = palette::sound, .pixels = 3, .alpha = alpha});
            canvas.arc(at, radius, -1.15, 1.0, {.colour = palette::sound, .pixels = 3, .alpha = alpha});
        }
    }
}

void drawCoil(Canvas& canvas, Point at, bool live) {
    Glow const glow = live ? Glow{palette::live, 0.25, 0.7F} : Glow{};
    canvas.box({at, 0}, {0.78, 0.12}, 0.03, {.pattern = Pattern::Metal});
    for (double const x : {-0.56, 0.56}) {
        canvas.box({at + Point{x, 0}, 0}, {0.05, 0.40}, 0.02, {.pattern = Pattern::Rubber});
    }
    for (int i = 0; i < 11; ++i) {
        double const x = -0.45 + 0.09 * i;
        canvas.capsule(at + Point{x - 0.02, -0.30}, at + Point{x + 0.02, 0.30}, 0.05,
                       {.pattern = Pattern::Copper, .outline = 1.4F, .glow = i == 5 ? glow : Glow{}});
    }
}

void drawWire(Canvas& canvas, std::span<Point const> path, bool live, double time) {
    Stroke wire{.colour = live ? palette::live : palette::deadWire,
                .width = 0.07,
                .outline = 1.5F,
                .round = true,
                .height = 1.F};
    if (live) {
        wire.glow = {palette::live, 0.16, 0.7F};
    }
    canvas.polyline(path, wire);
    if (live) {
        canvas.beads(path, 0.26, time * 3, 0.024, palette::liveCore);
    }
}

} // namespace

void drawTrembler(Canvas& canvas, double time) {
    double const pull = pulled(time);
    bool const live = std::fmod(time, titlePeriod) < ringing && pull < 0.6;
    // The board on which everything is mounted.
    canvas.box({{0, 0}, 0}, {3.1, 1.75}, 0.12,
               {.pattern = Pattern::Wood, .tint = mix(palette::wood, palette::paper, 0.35F), .grain = 0.22});
    canvas.newSheet();
    Point const pivot{-0.55, -1.25};
    double const lean = 0.02 + 0.150 * pull;
    Pose const arm{pivot, -lean};
    // Battery, at the left.
    canvas.box({{-2.35, -0.35}, 0}, {0.34, 0.66}, 0.06, {.pattern = Pattern::Rubber});
    canvas.box({{-2.35, -0.12}, 0}, {0.34, 0.22}, 0.03, {.pattern = Pattern::Plastic, .height = 0});
    canvas.box({{-2.35, 0.37}, 0}, {0.12, 0.07}, 0.02, {.pattern = Pattern::Metal});
    canvas.line({-2.45, -0.12}, {-2.25, -0.12}, {.colour = palette::ink, .width = 0.035});
    canvas.line({-2.35, -0.22}, {-2.35, -0.02}, {.colour = palette::ink, .width = 0.035});
    // Wires: battery, contact screw, arm; coil, battery.
    Point const screw{-0.64, 0.30};
    auto const first = bezier({-2.35, 0.42}, {-2.35, 1.35}, {-1.5, 1.35}, {-1.35, 0.32}, 28);
    auto const second = bezier({-2.35, -1.0}, {-2.35, -1.75}, {0.95, -1.75}, {1.02, -0.56}, 32);
    auto const third = bezier({0.20, -0.50}, {0.20, -0.95}, {0.0, -1.30}, {-0.34, -1.30}, 20);
    drawWire(canvas, first, live, time);
    drawWire(canvas, second, live, -time);
    drawWire(canvas, third, live, -time);
    drawCoil(canvas, {0.62, -0.22}, live);
    // The contact screw, the armature with its hammer, the spring's mount.
    canvas.capsule({-1.52, 0.30}, screw, 0.045, {.pattern = Pattern::Copper});
    canvas.box({{-1.36, 0.30}, 0}, {0.10, 0.24}, 0.03, {.pattern = Pattern::Metal});
    canvas.newSheet();
    canvas.box({{-0.55, -1.33}, 0}, {0.24, 0.16}, 0.03, {.pattern = Pattern::Metal});
    Point const tip = toWorld(arm, {0, 2.35});
    canvas.capsule(toWorld(arm, {0, 0.05}), toWorld(arm, {0, 1.75}), 0.06, {.pattern = Pattern::Metal});
    canvas.capsule(toWorld(arm, {0, 1.7}), tip, 0.035, {.pattern = Pattern::Metal});
    canvas.box({toWorld(arm, {0, 1.03}), -lean}, {0.11, 0.42}, 0.03, {.pattern = Pattern::Metal});
    canvas.circle({tip, 0}, 0.15, {.pattern = Pattern::Metal});
    if (live && pull > 0.02 && pull < 0.25) {
        canvas.glow({-0.60, 0.30}, 0.03, {palette::live, 0.26, 1.F});
    }
    drawBell(canvas, {0.72, 1.06}, pull > 0.75 ? 1.0 : (std::fmod(time, titlePeriod) < ringing ? 0.35 : 0.0));
    for (double const x : {-2.9, 2.9}) {
        for (double const y : {-1.55, 1.55}) {
            canvas.circle({{x, y}, 0.7}, 0.07, {.pattern = Pattern::Metal, .height = 0.4F});
            canvas.line({x - 0.04, y - 0.03}, {x + 0.04, y + 0.03}, {.colour = palette::ink, .width = 0.018});
        }
    }
}

} // namespace trembler::ui
