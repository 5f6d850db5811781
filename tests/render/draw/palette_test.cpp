// Colours with a meaning are distinguishable for colour-blind people, and text contrasts with its background.
#include "render/draw/palette.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace trembler::render::test {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple linear(Colour colour) {
    auto const channel = [](std::uint8_t value) {
        double const c = value / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

Triple times(Matrix const& m, Triple const& v) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = std::clamp(m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2], 0.0, 1.0);
    }
    return result;
}

/// CIE L*a*b* (D65) from linear sRGB.
Triple lab(Triple const& rgb) {
    constexpr Matrix toXyz{{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
    auto const f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    Triple xyz{};
    for (std::size_t i = 0; i < 3; ++i) {
        xyz[i] = toXyz[i][0] * rgb[0] + toXyz[i][1] * rgb[1] + toXyz[i][2] * rgb[2];
    }
    double const x = f(xyz[0] / 0.95047);
    double const y = f(xyz[1]);
    double const z = f(xyz[2] / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// Colours as dichromats see them, for linear sRGB: Machado, Oliveira and Fernandes 2009, severity 1.
constexpr std::array<Matrix, 4> eyes{
    Matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    Matrix{
        {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    Matrix{
        {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    Matrix{
        {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}},
};

double difference(Colour a, Colour b, Matrix const& eye) {
    auto const p = lab(times(eye, linear(a)));
    auto const q = lab(times(eye, linear(b)));
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double contrast(Colour a, Colour b) {
    auto const luminance = [](Colour colour) {
        auto const c = linear(colour);
        return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    };
    double const high = std::max(luminance(a), luminance(b));
    double const low = std::min(luminance(a), luminance(b));
    return (high + 0.05) / (low + 0.05);
}

TEST(Palette, ColoursOfOppositeMeaningDifferForAllKindsOfColourVision) {
    struct Pair {
        char const* what;
        Colour a;
        Colour b;
    };
    std::array const pairs{
        Pair{"poles", palette::northPole, palette::southPole},
        Pair{"live and dead wire", palette::live, palette::deadWire},
        Pair{"reached and wrong", palette::goal, palette::warning},
        Pair{"selection and wrong", palette::accent, palette::warning},
        Pair{"force and live", palette::force, palette::live},
        Pair{"steel and copper", palette::steel, palette::copper},
        Pair{"wood and stone", palette::wood, palette::stone},
    };
    for (auto const& pair : pairs) {
        for (std::size_t eye = 0; eye < eyes.size(); ++eye) {
            // 2.3 is just noticeable side by side; ten times that is a different colour in a glance.
            EXPECT_GT(difference(pair.a, pair.b, eyes[eye]), 20) << pair.what << ", eye " << eye;
        }
    }
}

TEST(Palette, OverlaysStandOutFromThePaper) {
    for (auto const colour :
         {palette::force, palette::fieldLine, palette::contact, palette::deadWire, palette::warning,
          palette::goal, palette::accent, palette::northPole, palette::southPole}) {
        EXPECT_GT(contrast(colour, palette::paper), 3.0);
    }
}

TEST(Palette, TextCanBeRead) {
    for (auto const ground : {palette::paper, palette::paperLight, palette::paperShade}) {
        EXPECT_GT(contrast(palette::ink, ground), 7);
    }
    EXPECT_GT(contrast(palette::inkSoft, palette::paperLight), 4.5);
    EXPECT_GT(contrast(palette::paperLight, palette::accent), 4.5);
    EXPECT_GT(contrast(palette::paperLight, palette::warning), 4.5);
    EXPECT_GT(contrast(palette::paperLight, palette::goal), 4.5);
}

TEST(Colours, AreMixedAndPacked) {
    static_assert(rgb(0x123456) == Colour{0x12, 0x34, 0x56, 255});
    static_assert(packed(rgb(0x123456)) == 0xFF563412U);
    static_assert(mix(rgb(0x000000), rgb(0xFFFFFF), 0.5F).green == 128);
    static_assert(faded(rgb(0), 0.5F).alpha == 128);
    static_assert(faded(rgb(0), 7.F).alpha == 255);
    SUCCEED();
}

} // namespace
} // namespace trembler::render::test
