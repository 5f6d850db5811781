// Shapes cover the pixels of their geometry, in the order in which they were drawn.
#include "tests/render/stage.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace trembler::render::test {
namespace shape_batch_test {
namespace {

constexpr Colour black = rgb(0x000000);
constexpr Colour white = rgb(0xFFFFFF);
constexpr Size size{400, 300};

/// White, flat, without rim and shadow, so that a pixel's brightness is its covered share.
Style bare() {
    return {.tint = white, .outline = 0.F, .height = 0.F, .layer = Layer::Rim};
}

/// White area in square metres, at 100 pixels per metre.
double whiteArea(Image const& image) {
    double sum = 0;
    for (std::size_t i = 1; i < image.bytes().size(); i += 4) {
        sum += image.bytes()[i] / 255.0;
    }
    return sum / 1e4;
}

Image whiteShape(std::function<void(Canvas&, Style const&)> const& draw) {
    auto style = bare();
    // The rim layer has one uniform colour all over the shape.
    style.outlineColour = white;
    return picture(size, black, [&](Canvas& canvas) { draw(canvas, style); });
}

TEST(Shapes, CircleCoversItsArea) {
    auto const image = whiteShape([](Canvas& canvas, Style const& style) {
        canvas.circle({{0.313, -0.207}, 0.5}, 0.8, style);
    });
    EXPECT_NEAR(whiteArea(image) / (std::numbers::pi * 0.64), 1.0, 0.01);
    // Inside and outside by two pixels, in 32 directions.
    for (int i = 0; i < 32; ++i) {
        double const angle = i * std::numbers::pi / 16;
        auto const pixel = [&](double radius) {
            auto const at = canvas().camera().toScreen(
                {0.313 + radius * std::cos(angle), -0.207 + radius * std::sin(angle)});
            return image.at(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)))[1];
        };
        EXPECT_EQ(pixel(0.78), 255) << i;
        EXPECT_EQ(pixel(0.82), 0) << i;
    }
}

TEST(Shapes, TurnedBoxCoversItsArea) {
    auto const sharp = whiteShape([](Canvas& canvas, Style const& style) {
        canvas.box({{0.1, 0.2}, 0.7}, {0.9, 0.4}, 0, style);
    });
    EXPECT_NEAR(whiteArea(sharp) / (4 * 0.9 * 0.4), 1.0, 0.01);
    auto const rounded = whiteShape([](Canvas& canvas, Style const& style) {
        canvas.box({{0.1, 0.2}, 0.7}, {0.9, 0.4}, 0.3, style);
    });
    EXPECT_NEAR(whiteArea(rounded) / (4 * 0.9 * 0.4 - (4 - std::numbers::pi) * 0.09), 1.0, 0.01);
}

TEST(Shapes, CapsuleCoversItsArea) {
    auto const image = whiteShape([](Canvas& canvas, Style const& style) {
        canvas.capsule({-0.9, -0.5}, {0.6, 0.4}, 0.25, style);
    });
    double const span = std::hypot(1.5, 0.9);
    EXPECT_NEAR(whiteArea(image) / (span * 0.5 + std::numbers::pi * 0.0625), 1.0, 0.01);
}

TEST(Shapes, PolygonCoversItsAreaInEitherOrientation) {
    std::array corners{Point{-0.8, -0.6}, Point{0.9, -0.5}, Point{0.7, 0.6}, Point{-0.1, 0.9},
                       Point{-0.7, 0.3}};
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        auto const& a = corners[i];
        auto const& b = corners[(i + 1) % corners.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    auto const draw = [&](Canvas& canvas, Style const& style) {
        canvas.polygon({{0.2, -0.1}, 0.4}, corners, style);
    };
    EXPECT_NEAR(whiteArea(whiteShape(draw)) / (0.5 * twice), 1.0, 0.01);
    std::reverse(corners.begin(), corners.end());
    EXPECT_NEAR(whiteArea(whiteShape(draw)) / (0.5 * twice), 1.0, 0.01);
}

TEST(Shapes, PolygonNeedNotBeConvex) {
    std::array const corners{Point{-0.8, -0.8}, Point{0.8, -0.8}, Point{0.8, 0.8}, Point{0, 0},
                             Point{-0.8, 0.8}};
    auto const image =
        whiteShape([&](Canvas& canvas, Style const& style) { canvas.polygon({}, corners, style); });
    EXPECT_NEAR(whiteArea(image) / (1.6 * 1.6 - 0.8 * 0.8), 1.0, 0.01);
}

TEST(Shapes, RingAndArcCoverTheirArea) {
    Stroke const stroke{.colour = white, .width = 0.2};
    auto const ring = picture(size, black, [&](Canvas& canvas) { canvas.ring({0, 0}, 0.8, stroke); });
    EXPECT_NEAR(whiteArea(ring) / (2 * std::numbers::pi * 0.8 * 0.2), 1.0, 0.01);
    auto const arc = picture(size, black, [&](Canvas& canvas) { canvas.arc({0, 0}, 0.8, 1, -2.5, stroke); });
    EXPECT_NEAR(whiteArea(arc) / (2.5 * 0.8 * 0.2 + std::numbers::pi * 0.01), 1.0, 0.01);
}

TEST(Shapes, ArrowEndsAtItsPoint) {
    auto const image = picture(size, black, [](Canvas& canvas) {
        canvas.arrow({-1, 0.005}, {1, 0.005}, {.colour = white, .width = 0.1});
    });
    auto const row = size.height / 2 - 1; // the pixels around y = 0.005
    EXPECT_EQ(image.at(200 + 97, row)[1] > 100, true);
    EXPECT_EQ(image.at(200 + 101, row)[1], 0);
    EXPECT_EQ(image.at(200 - 99, row)[1], 255);
    EXPECT_EQ(image.at(200 - 102, row)[1], 0);
}

TEST(Shapes, LaterOnesLieOnTop) {
    auto const red = rgb(0xFF0000);
    auto const blue = rgb(0x0000FF);
    Style first = bare();
    first.outlineColour = red;
    Style second = bare();
    second.outlineColour = blue;
    std::array const square{Point{-0.5, -0.5}, Point{0.5, -0.5}, Point{0.5, 0.5}, Point{-0.5, 0.5}};
    // Shapes of different kinds must keep their order.
    auto const image = picture(size, black, [&](Canvas& canvas) {
        canvas.polygon({}, square, first);
        canvas.circle({}, 0.4, second);
        canvas.line({-0.2, 0}, {0.2, 0}, {.colour = red, .width = 0.1});
        canvas.circle({}, 0.02, second);
    });
    EXPECT_EQ(image.at(200 + 45, 150), (Pixel{255, 0, 0, 255}));
    EXPECT_EQ(image.at(200 + 30, 150), (Pixel{0, 0, 255, 255}));
    EXPECT_EQ(image.at(200 + 15, 150), (Pixel{255, 0, 0, 255}));
    EXPECT_EQ(image.at(200, 150), (Pixel{0, 0, 255, 255}));
}

TEST(Shapes, OutlineLiesInsideTheTrueEdge) {
    auto const draw = [](float outline) {
        return whiteArea(picture(size, black, [&](Canvas& canvas) {
            canvas.circle({}, 0.8,
                          {.tint = white,
                           .outline = outline,
                           .outlineColour = white,
                           .height = 0.F,
                           .layer = Layer::Rim});
        }));
    };
    EXPECT_DOUBLE_EQ(draw(0.F), draw(6.F));
}

TEST(Shapes, OnlyInvalidShapesAreLeftOut) {
    double const nan = std::numeric_limits<double>::quiet_NaN();
    double const far = std::numeric_limits<double>::infinity();
    auto const image = whiteShape([&](Canvas& canvas, Style const& style) {
        canvas.circle({{nan, 0}, 0}, 1, style);
        canvas.circle({{0, 0}, nan}, 1, style);
        canvas.circle({{0, 0}, 0}, -1, style);
        canvas.circle({{0, 0}, 0}, far, style);
        canvas.box({{0, far}, 0}, {1, 1}, nan, style);
        canvas.capsule({0, 0}, {nan, 0}, 0.1, style);
        std::array const broken{Point{0, 0}, Point{1, 0}, Point{nan, 1}};
        canvas.polygon({}, broken, style);
        canvas.polygon({}, std::span(broken).first(2), style);
        canvas.polyline(broken, {.colour = white, .width = 0.1});
        canvas.arrow({0, 0}, {0, 0}, {.colour = white, .width = 0.1});
        canvas.arrow({0, 0}, {far, 0}, {.colour = white, .width = 0.1});
        canvas.ring({0, nan}, 1, {.colour = white, .width = 0.1});
        canvas.glow({0, 0}, 1, {.reach = nan, .strength = 1.F});
        canvas.beads(broken, 0.1, nan, 0.1, white);
        canvas.circle({{0, 0}, 0}, 0.5, style);
    });
    EXPECT_NEAR(whiteArea(image) / (std::numbers::pi * 0.25), 1.0, 0.01);
}

TEST(Shapes, ShapesOutOfViewAreNotSent) {
    picture(size, black, [](Canvas& canvas) {
        for (int i = 0; i < 100; ++i) {
            canvas.circle({{50.0 + i, 0}, 0}, 0.5, {});
        }
        canvas.circle({}, 0.5, {.height = 0.F});
    });
    EXPECT_EQ(canvas().drawn(), 1U);
}

TEST(Shapes, AreAsExactFarFromTheOrigin) {
    auto const draw = [](double offset) {
        Camera camera;
        camera.centre = {offset, -offset};
        Style style = bare();
        style.outlineColour = white;
        return picture(
            size, black,
            [&](Canvas& canvas) {
                canvas.circle({{offset + 0.25, -offset}, 0}, 0.8, style);
            },
            {}, camera);
    };
    EXPECT_EQ(draw(0), draw(1048576.0));
}

} // namespace
} // namespace shape_batch_test
} // namespace trembler::render::test
