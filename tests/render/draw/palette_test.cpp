// Colours with a meaning are distinguishable for colour-blind people, and text contrasts with its background.
#include "render/draw/palette.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

constexpr double radian = 3.14159265358979323846 / 180;

/// CIEDE2000 of two colours in L*a*b*: Sharma, Wu and Dalal, "The CIEDE2000 color-difference formula", 2005.
double difference2000(Triple const& p, Triple const& q) {
    double const mean = 0.5 * (std::hypot(p[1], p[2]) + std::hypot(q[1], q[2]));
    double const seventh = std::pow(mean, 7);
    double const grown = 1 + 0.5 * (1 - std::sqrt(seventh / (seventh + std::pow(25.0, 7))));
    double const c1 = std::hypot(grown * p[1], p[2]);
    double const c2 = std::hypot(grown * q[1], q[2]);
    auto const hue = [&](Triple const& lab) {
        double const angle = std::atan2(lab[2], grown * lab[1]) / radian;
        return angle < 0 ? angle + 360 : angle;
    };
    double const h1 = hue(p);
    double const h2 = hue(q);
    bool const grey = c1 * c2 == 0;
    bool const around = std::abs(h1 - h2) > 180;
    double turn = grey ? 0 : h2 - h1;
    turn += turn > 180 ? -360 : turn < -180 ? 360 : 0;
    double const dh = 2 * std::sqrt(c1 * c2) * std::sin(0.5 * turn * radian);
    double const l = 0.5 * (p[0] + q[0]);
    double const c = 0.5 * (c1 + c2);
    double const sum = h1 + h2;
    double const h = grey ? sum : !around ? 0.5 * sum : 0.5 * (sum < 360 ? sum + 360 : sum - 360);
    double const t = 1 - 0.17 * std::cos((h - 30) * radian) + 0.24 * std::cos(2 * h * radian) +
                     0.32 * std::cos((3 * h + 6) * radian) - 0.20 * std::cos((4 * h - 63) * radian);
    double const sl = 1 + 0.015 * (l - 50) * (l - 50) / std::sqrt(20 + (l - 50) * (l - 50));
    double const sc = 1 + 0.045 * c;
    double const sh = 1 + 0.015 * c * t;
    double const c7 = std::pow(c, 7);
    double const rotation = -2 * std::sqrt(c7 / (c7 + std::pow(25.0, 7))) *
                            std::sin(60 * std::exp(-std::pow((h - 275) / 25, 2)) * radian);
    double const x = (q[0] - p[0]) / sl;
    double const y = (c2 - c1) / sc;
    double const z = dh / sh;
    return std::sqrt(x * x + y * y + z * z + rotation * y * z);
}

double difference(Colour a, Colour b, Matrix const& eye) {
    return difference2000(lab(times(eye, linear(a))), lab(times(eye, linear(b))));
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

TEST(Difference, IsThatOfThePublishedPairs) {
    EXPECT_NEAR(difference2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 1e-4);
    EXPECT_NEAR(difference2000({50, 2.5, 0}, {50, 0, -2.5}), 4.3065, 1e-4);
    EXPECT_NEAR(difference2000({50, 2.5, 0}, {73, 25, -18}), 27.1492, 1e-4);
    EXPECT_NEAR(difference2000({90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}), 1.4441, 1e-4);
}

/// The least difference, of all kinds of eyes, between colours that stand for different things in one place.
double leastDifference(palette::Meanings const& m, std::size_t eyesToTry) {
    std::array const pairs{std::pair{m.goal, m.warning},    std::pair{m.accent, m.warning},
                           std::pair{m.accent, m.goal},     std::pair{m.northPole, m.southPole},
                           std::pair{m.live, m.deadWire},   std::pair{m.live, palette::copper},
                           std::pair{m.force, m.contact},   std::pair{m.force, m.fieldLine},
                           std::pair{m.force, m.sound},     std::pair{m.fieldLine, m.contact},
                           std::pair{m.fieldLine, m.sound}, std::pair{m.contact, m.sound},
                           std::pair{m.force, m.live},      std::pair{m.accent, m.secondHand},
                           std::pair{m.goal, m.secondHand}, std::pair{m.warning, m.secondHand},
                           std::pair{m.live, m.secondHand}};
    double least = 1000;
    for (auto const& [a, b] : pairs) {
        for (std::size_t eye = 0; eye < eyesToTry; ++eye) {
            least = std::min(least, difference(a, b, eyes[eye]));
        }
    }
    return least;
}

// About 1 is just noticeable side by side; twenty times that is a different colour at a glance.
TEST(Palette, ItsColoursWithAMeaningDiffer) {
    EXPECT_GT(leastDifference(palette::meanings[0], 1), 20) << "the usual colours, for normal sight";
    EXPECT_GT(leastDifference(palette::meanings[1], eyes.size()), 20) << "the clear colours, for all eyes";
}

TEST(Palette, IsWhatIsInUse) {
    palette::use(palette::Choice::clear);
    EXPECT_EQ(palette::goal, palette::meanings[1].goal);
    EXPECT_EQ(palette::inUse(), palette::Choice::clear);
    palette::use(palette::Choice::usual);
    EXPECT_EQ(palette::goal, palette::meanings[0].goal);
}

TEST(Palette, OverlaysStandOutFromThePaper) {
    for (palette::Meanings const& m : palette::meanings) {
        for (Colour const colour : {m.force, m.fieldLine, m.contact, m.deadWire, m.warning, m.goal, m.accent,
                                    m.northPole, m.southPole, m.sound, m.secondHand}) {
            EXPECT_GT(contrast(colour, palette::paper), 3.0);
        }
    }
}

TEST(Palette, TextCanBeRead) {
    for (auto const ground : {palette::paper, palette::paperLight, palette::paperShade}) {
        EXPECT_GT(contrast(palette::ink, ground), 7);
    }
    EXPECT_GT(contrast(palette::inkSoft, palette::paperLight), 4.5);
    for (palette::Meanings const& m : palette::meanings) {
        for (Colour const colour : {m.accent, m.warning, m.goal}) {
            EXPECT_GT(contrast(palette::paperLight, colour), 4.5);
        }
    }
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
