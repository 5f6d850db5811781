// Axes with round ticks that hold all values, and plots with a line for each series.
#include "insight/probe/plot.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace trembler::insight {
namespace {

TEST(Axis, HasRoundTicksWithinItsRange) {
    EXPECT_TRUE(rc::check([](std::int32_t a, std::int32_t b, std::uint8_t scale) {
        double const unit = std::pow(10.0, static_cast<double>(scale % 13) - 6);
        Axis const axis = axisFor(a * unit, b * unit, 4);
        std::vector<double> const ticks = axis.ticks();
        RC_ASSERT(axis.low < axis.high);
        RC_ASSERT((axis.low <= std::min(a, b) * unit) && (axis.high >= std::max(a, b) * unit));
        RC_ASSERT((ticks.size() <= 10U));
        double const mantissa = axis.step / std::pow(10.0, std::floor(std::log10(axis.step) + 1e-9));
        RC_ASSERT((std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 ||
                   std::abs(mantissa - 5) < 1e-6));
        for (double const tick : ticks) {
            RC_ASSERT((axis.share(tick) > -1e-6 && axis.share(tick) < 1 + 1e-6));
            RC_ASSERT(std::abs(tick / axis.step - std::round(tick / axis.step)) < 1e-6);
        }
    }));
}

TEST(Axis, TakesAnything) {
    double const infinite = std::numeric_limits<double>::infinity();
    for (double const low : {0.0, -infinite, std::nan(""), 5.0, 1e300}) {
        for (double const high : {0.0, infinite, std::nan(""), 5.0}) {
            Axis const axis = axisFor(low, high, 4);
            EXPECT_TRUE(axis.low < axis.high) << low << " " << high;
            EXPECT_LE(axis.ticks().size(), 20U);
        }
    }
    EXPECT_EQ(tickText(0.25, 0.05), "0.25");
    EXPECT_EQ(tickText(-3, 1), "-3");
    EXPECT_EQ(tickText(1e-17, 1), "0");
}

TEST(Plot, HasAPanelForEachUnitAndALineForEachSeries) {
    std::vector<Series> series{{"ball.velocity.x", "m/s", {{0, 1}, {1, 2}, {2, 1}}},
                               {"lamp.current", "A", {{0, 0}, {60, 5}}},
                               {"a <b> & c", "m/s", {{0, -4}}}};
    EXPECT_EQ(panelsOf(series, 4).size(), 2U);
    std::string const svg = plotAsSvg("A \"title\" <&>", series, 60);
    auto const count = [&](std::string const& what) {
        std::size_t n = 0;
        for (std::size_t at = svg.find(what); at != std::string::npos; at = svg.find(what, at + 1)) {
            ++n;
        }
        return n;
    };
    EXPECT_EQ(count("<path "), 3U);
    EXPECT_EQ(count(">ball.velocity.x<"), 1U);
    EXPECT_EQ(count("a &lt;b&gt; &amp; c"), 1U);
    EXPECT_EQ(count("<text "), count("</text>"));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(plotAsSvg("", {}, 0).find("nan"), std::string::npos);
}

TEST(Series, HasTheValueOfTheLatestFrame) {
    Series const series{"", "", {{3, 1.5}, {6, 2.5}}};
    EXPECT_FALSE(series.at(2));
    EXPECT_EQ(series.at(3), 1.5);
    EXPECT_EQ(series.at(5), 1.5);
    EXPECT_EQ(series.at(100), 2.5);
}

} // namespace
} // namespace trembler::insight
