// Pictures for people: every material, line and overlay on one sheet, at the two sizes that must be readable.
#include "render/draw/path.hpp"
#include "tests/render/stage.hpp"

#include <cmath>

namespace trembler::render::test {
namespace {

constexpr std::array allPatterns{Pattern::Plain,   Pattern::Metal,  Pattern::Wood,
                                 Pattern::Glass,   Pattern::Rubber, Pattern::Stone,
                                 Pattern::Plastic, Pattern::Copper, Pattern::Water};

Camera sheetCamera(Size size) {
    Camera camera;
    camera.viewport = size;
    camera.fit({-6.4, -3.6}, {6.4, 3.6}, 0);
    return camera;
}

void drawMaterials(Canvas& canvas) {
    canvas.paper();
    std::array const hexagon{Point{0.5, 0},  Point{0.25, 0.43},   Point{-0.25, 0.43},
                             Point{-0.5, 0}, Point{-0.25, -0.43}, Point{0.25, -0.43}};
    std::array const ramp{Point{-0.55, -0.35}, Point{0.55, -0.35}, Point{0.55, 0.35}};
    double x = -5.6;
    for (auto const pattern : allPatterns) {
        Style const style{.pattern = pattern};
        canvas.box({{x, 2.8}, 0}, {0.5, 0.4}, 0.06, style);
        canvas.circle({{x, 1.65}, 0.4}, 0.48, style);
        canvas.polygon({{x, 0.5}, 0.2}, hexagon, style);
        canvas.polygon({{x, -0.5}, 0}, ramp, style);
        canvas.capsule({x - 0.45, -1.5}, {x + 0.45, -1.15}, 0.13, style);
        canvas.box({{x, -2.2}, 0.5}, {0.62, 0.09}, 0.02, style);
        canvas.circle({{x - 0.35, -3.0}, 0}, 0.12, style);
        canvas.box({{x + 0.1, -3.0}, 0.2}, {0.12, 0.12}, 0.02, style);
        x += 1.4;
    }
}

void drawLines(Canvas& canvas) {
    canvas.paper();
    auto const wire = [](Colour colour) {
        return Stroke{.colour = colour, .width = 0.11, .outline = 1.6F, .round = true, .height = 1.F};
    };
    auto const dead = hangingWire({-6, 3}, {-3, 2.6}, 0.7);
    canvas.polyline(dead, wire(palette::deadWire));
    auto liveStroke = wire(palette::live);
    liveStroke.glow = {palette::live, 0.28, 0.8F};
    auto const live = hangingWire({-2.6, 3}, {0.6, 2.6}, 0.7, 24);
    canvas.polyline(live, liveStroke);
    canvas.beads(live, 0.3, 0.4, 0.035, palette::liveCore);
    canvas.polyline(bezier({1.2, 3}, {3.4, 3.4}, {0.4, 1.5}, {2.4, 1.6}, 24), wire(palette::copper));
    canvas.polyline(coil({3, 2.3}, {6, 2.3}, 0.22, 9),
                    Stroke{.colour = palette::steel, .width = 0.06, .outline = 1.4F, .height = 0.6F});
    // A bar magnet with its field lines.
    canvas.box({{-4, 0.4}, 0}, {0.9, 0.28}, 0.04, {.pattern = Pattern::Plastic, .tint = palette::southPole});
    canvas.box({{-3.55, 0.4}, 0}, {0.45, 0.28}, 0.04,
               {.pattern = Pattern::Plastic, .tint = palette::northPole});
    for (int i = 1; i <= 3; ++i) {
        for (double const side : {1.0, -1.0}) {
            double const h = 0.7 * i * side;
            auto const field =
                bezier({-3.1, 0.4}, {-2.4 + 0.2 * i, 0.4 + h}, {-5.6 - 0.2 * i, 0.4 + h}, {-4.9, 0.4}, 28);
            canvas.polyline(field, {.colour = palette::fieldLine, .pixels = 1.8F, .alpha = 0.6F});
        }
    }
    for (int i = 0; i < 8; ++i) {
        double const angle = i * 0.785;
        Point const at{0, 0.4};
        canvas.arrow(at + 0.3 * Point{std::cos(angle), std::sin(angle)},
                     at + (0.5 + 0.1 * i) * Point{std::cos(angle), std::sin(angle)},
                     {.colour = palette::force, .pixels = 4.5F, .outline = 1.2F});
    }
    for (int i = 0; i < 5; ++i) {
        canvas.ring({2.6, 0.4}, 0.25 + 0.22 * i,
                    {.colour = palette::sound, .pixels = 2.2F, .alpha = 1.F - 0.19F * static_cast<float>(i)});
    }
    canvas.arc({5, 0.4}, 0.7, 0.3, 4.2,
               {.colour = palette::accent, .width = 0.16, .outline = 1.6F, .round = true});
    canvas.glow({-5.3, -2.2}, 0.2, {palette::live, 0.8, 0.9F});
    canvas.circle({{-5.3, -2.2}, 0}, 0.25, {.pattern = Pattern::Glass, .tint = palette::liveCore});
    Style style{.pattern = Pattern::Wood};
    style.selected = true;
    canvas.box({{-3.5, -2.2}, 0.15}, {0.7, 0.3}, 0.05, style);
    style = {.pattern = Pattern::Metal};
    style.ghost = true;
    canvas.box({{-1.6, -2.2}, 0.15}, {0.7, 0.3}, 0.05, style);
    style.forbidden = true;
    canvas.box({{0.4, -2.2}, 0.15}, {0.7, 0.3}, 0.05, style);
    style = {.pattern = Pattern::Copper};
    style.hovered = true;
    canvas.box({{2.4, -2.2}, 0.15}, {0.7, 0.3}, 0.05, style);
    for (auto const layer : {Layer::Rim, Layer::Inside}) {
        style = {.pattern = Pattern::Metal};
        style.layer = layer;
        canvas.box({{4.6, -2.2}, 0.15}, {0.7, 0.12}, 0.05, style);
        canvas.circle({{5.2, -2.1}, 0.15}, 0.32, style);
        canvas.circle({{4.0, -2.3}, 0.15}, 0.25, style);
    }
    style = {.pattern = Pattern::Metal};
    style.glow = {palette::live, 0.25, 0.8F};
    canvas.box({{6, -1.0}, 0.3}, {0.25, 0.25}, 0.05, style);
}

void save(std::string const& name, void (*draw)(Canvas&)) {
    for (auto const size : {Size{1280, 720}, Size{3840, 2160}}) {
        window().resize(size);
        auto const image = picture(size, palette::paper, draw, {.uiScale = window().uiScale(), .time = 1.0},
                                   sheetCamera(size));
        keepForPeople(image, name + "-" + std::to_string(size.height));
    }
}

TEST(Sheets, Materials) {
    save("materials", drawMaterials);
}

TEST(Sheets, Lines) {
    save("lines", drawLines);
}

} // namespace
} // namespace trembler::render::test
