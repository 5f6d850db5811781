// Rings around sounding objects.
#include "render/scene/overlays/overlay_sound.hpp"
#include "tests/render/stage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace trembler::render::test {
namespace {

constexpr Size size{400, 400}; // 100 pixels per metre: 4 m by 4 m

Image drawn(std::vector<Ripple> const& ripples) {
    return picture(size, palette::paper, [&](Canvas& canvas) { drawRipples(canvas, ripples); });
}

/// By how much the darkest pixel `away` metres from the middle, in any of 32 directions, differs from the
/// paper: 0 to 255.
int darkness(Image const& image, double away) {
    int most = 0;
    constexpr int directions = 32;
    constexpr double pi = 3.14159265358979;
    for (int i = 0; i < directions; ++i) {
        double const angle = 2 * pi * i / directions;
        auto const x = static_cast<int>(std::floor(200 + 100 * away * std::cos(angle)));
        auto const y = static_cast<int>(std::floor(200 - 100 * away * std::sin(angle)));
        most = std::max(most, std::abs(int{image.at(x, y)[0]} - palette::paper.red));
    }
    return most;
}

TEST(Ripples, AreDrawnAtTheirRadiusOnly) {
    Image const image = drawn({{{0, 0}, 1, 1}});
    EXPECT_GT(darkness(image, 1), 20);
    for (double const away : {0.0, 0.5, 0.9, 1.1, 1.5}) {
        EXPECT_EQ(darkness(image, away), 0) << away << " m";
    }
}

TEST(Ripples, AreFainterIfWeaker) {
    int const strong = darkness(drawn({{{0, 0}, 1, 1}}), 1);
    int const weak = darkness(drawn({{{0, 0}, 1, 0.1}}), 1);
    EXPECT_GT(strong, weak);
    EXPECT_GT(weak, 0);
    EXPECT_LT(strong, 128) << "translucent: objects below remain visible";
}

TEST(Ripples, OfNoStrengthOrNoRadiusAreNotDrawn) {
    Image const empty = drawn({});
    double const nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(drawn({{{0, 0}, 1, 0}, {{0, 0}, 0, 1}, {{0, 0}, 1, -1}, {{0, 0}, 1, nan}, {{0, 0}, nan, 1}}),
              empty);
}

} // namespace
} // namespace trembler::render::test
