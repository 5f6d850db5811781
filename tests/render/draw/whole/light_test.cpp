// Glows, shadows and translucent lines: their contribution to a picture, and the pixels that they must not
// change.
#include "render/draw/path.hpp"
#include "tests/render/stage.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace trembler::render::test {
namespace light_test {
namespace {

constexpr Size size{400, 300};

/// Along a line from the middle to the right every channel goes from the glow's colour to the ground's and
/// never beyond either: no dark rim, no ring.
void expectMonotone(Image const& image, Pixel from, Pixel to, int first) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
        int const direction = to[channel] >= from[channel] ? 1 : -1;
        int before = image.at(first, size.height / 2)[channel];
        for (int x = first + 1; x < size.width; ++x) {
            int const now = image.at(x, size.height / 2)[channel];
            EXPECT_GE(direction * (now - before), -1) << "channel " << channel << " at " << x;
            before = now;
        }
        EXPECT_NEAR(before, to[channel], 1);
    }
}

TEST(Light, GlowHasNoDarkRim) {
    for (auto const ground : {palette::paper, rgb(0x000000), rgb(0xFFFFFF), palette::rubber}) {
        auto const image = picture(size, ground, [](Canvas& canvas) {
            canvas.glow({}, 0.4, {palette::live, 0.9, 0.9F});
        });
        auto const& glow = palette::live;
        expectMonotone(image, {glow.red, glow.green, glow.blue, 255},
                       {ground.red, ground.green, ground.blue, 255}, size.width / 2);
    }
}

TEST(Light, GlowIsEvenAlongABentPath) {
    // If segments overlapped, the joints would be brighter than the middles.
    auto const wire = bezier({-1.6, 0}, {-0.6, 0}, {0.6, 0}, {1.6, 0}, 16);
    auto const image = picture(size, rgb(0x000000), [&](Canvas& canvas) {
        canvas.polyline(wire, {.colour = rgb(0x000000), .width = 0.1, .glow = {rgb(0xFFFFFF), 0.4, 0.8F}});
    });
    for (int const y : {125, 135, 165, 175}) {
        int low = 255;
        int high = 0;
        for (int x = 60; x < 340; ++x) {
            low = std::min<int>(low, image.at(x, y)[0]);
            high = std::max<int>(high, image.at(x, y)[0]);
        }
        EXPECT_GT(low, 5);
        EXPECT_LE(high - low, 2) << "row " << y;
    }
}

TEST(Light, SeeThroughLineIsEvenAtSharpBends) {
    std::array const zigzag{Point{-1.5, -0.8}, Point{-0.5, 0.8}, Point{0.5, -0.8}, Point{1.5, 0.8}};
    auto const image = picture(size, rgb(0x000000), [&](Canvas& canvas) {
        canvas.polyline(zigzag, {.colour = rgb(0xFFFFFF), .width = 0.4, .alpha = 0.5F});
    });
    int brightest = 0;
    for (std::size_t i = 0; i < image.bytes().size(); i += 4) {
        brightest = std::max<int>(brightest, image.bytes()[i]);
    }
    EXPECT_NEAR(brightest, 128, 2);
}

TEST(Light, ATightBendHasNoHoles) {
    // A bend much tighter than the line is wide.
    auto const tight = bezier({-1, 0.1}, {1.2, 0.1}, {1.2, -0.1}, {-1, -0.1}, 40);
    for (float const alpha : {1.F, 0.6F}) {
        auto const image = picture(size, rgb(0x000000), [&](Canvas& canvas) {
            canvas.polyline(tight, {.colour = rgb(0xFFFFFF), .width = 0.6, .alpha = alpha});
        });
        int const expected = alpha < 1.F ? 153 : 255;
        for (int x = 110; x < 270; ++x) {
            for (int y = 135; y < 166; ++y) {
                EXPECT_GE(image.at(x, y)[0], expected - 2) << x << ' ' << y;
            }
        }
    }
}

TEST(Light, ShadowsCanBeSwitchedOff) {
    auto const draw = [](bool shadows, float height) {
        return picture(size, palette::paper,
                       [&](Canvas& canvas) {
                           canvas.box({}, {0.6, 0.4}, 0.05, {.pattern = Pattern::Wood, .height = height});
                       },
                       {.shadows = shadows});
    };
    auto const with = draw(true, 1.F);
    auto const without = draw(false, 1.F);
    EXPECT_NE(with, without);
    EXPECT_EQ(without, draw(true, 0.F));
    // The shadow falls to the lower right and only darkens.
    EXPECT_LT(with.at(200 + 30, 150 + 43)[1], without.at(200 + 30, 150 + 43)[1]);
    EXPECT_EQ(with.at(200 - 30, 150 - 46), without.at(200 - 30, 150 - 46));
    for (std::size_t i = 0; i < with.bytes().size(); ++i) {
        EXPECT_LE(with.bytes()[i], without.bytes()[i]);
    }
}

TEST(Light, ShadowsOfOneSheetLieUnderAllOfItsShapes) {
    auto const draw = [](bool newSheet) {
        return picture(size, palette::paper, [&](Canvas& canvas) {
            canvas.box({{0, -0.5}, 0}, {0.6, 0.3}, 0, {.pattern = Pattern::Plain});
            if (newSheet) {
                canvas.newSheet();
            }
            canvas.box({{0, 0.1}, 0}, {0.6, 0.3}, 0, {.pattern = Pattern::Plain});
        });
    };
    // Just below the edge between the upper box and the lower one, inside of the lower one's outline.
    EXPECT_LT(draw(true).at(200, 150 + 24)[1], draw(false).at(200, 150 + 24)[1]);
}

TEST(Light, MaterialsDiffer) {
    std::vector<Image> seen;
    for (int i = 0; i <= static_cast<int>(Pattern::Water); ++i) {
        // The same tint, so that only the pattern differs.
        auto image = picture(size, palette::paper, [&](Canvas& canvas) {
            canvas.box({}, {0.6, 0.4}, 0, {.pattern = static_cast<Pattern>(i), .tint = rgb(0x8090A0)});
        });
        for (auto const& other : seen) {
            // Copper is steel with more shine; all others differ in pattern.
            EXPECT_NE(image, other) << i;
        }
        seen.push_back(std::move(image));
    }
}

TEST(Light, StatesAreSeen) {
    auto const draw = [](void (*change)(Style&)) {
        Style style{.pattern = Pattern::Wood};
        change(style);
        return picture(size, palette::paper, [&](Canvas& canvas) { canvas.box({}, {0.6, 0.4}, 0, style); });
    };
    auto const usual = draw([](Style&) {});
    EXPECT_NE(usual, draw([](Style& style) { style.ghost = true; }));
    EXPECT_NE(usual, draw([](Style& style) { style.forbidden = true; }));
    EXPECT_NE(usual, draw([](Style& style) { style.hovered = true; }));
    auto const selected = draw([](Style& style) { style.selected = true; });
    auto const ring = selected.at(200 + 63, 150);
    EXPECT_LT(std::abs(ring[0] - palette::accent.red), 12);
    EXPECT_LT(std::abs(ring[2] - palette::accent.blue), 12);
}

} // namespace
} // namespace light_test
} // namespace trembler::render::test
