// Areas of the plane as files state them.
#include "runtime/level/json/limits.hpp"
#include "runtime/level/read/read_area.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

namespace trembler {
namespace read_area_test {
namespace {

struct Reading {
    std::optional<Area> area;
    std::vector<std::string> said;
};

Reading readingOf(std::string const& text) {
    auto const document = JsonDocument::parse(text, "f.json");
    Problems problems;
    Reading made;
    made.area = readArea(JsonNode(*document, document->root(), "", problems));
    try {
        problems.throwIfAny();
    } catch (InputError const& error) {
        for (Diagnostic const& one : error.diagnostics()) {
            made.said.push_back(one.print());
        }
    }
    return made;
}

std::string stated(std::vector<Vec2> const& corners) {
    nlohmann::json list = nlohmann::json::array();
    for (Vec2 const corner : corners) {
        list.push_back({corner.x, corner.y});
    }
    return list.dump();
}

TEST(ReadArea, ABoxIsFourNumbers) {
    Reading const read = readingOf("[1, -2, 3, 0.5]");
    ASSERT_TRUE(read.area && read.area->box);
    EXPECT_EQ(*read.area->box, (Box{{1, -2}, {3, 0.5}}));
    EXPECT_TRUE(read.area->corners.empty());
    EXPECT_TRUE(readingOf("[-1e6, 1e6, 0.001, 2e6]").area) << "at the ends of all ranges";
    struct Case {
        char const* text;
        char const* says;
    };
    for (Case const& c :
         {Case{"[0, 0, 0, 1]", "/2: is 0; expected a number from 0.001 to 2000000"},
          Case{"[0, 0, 1, -1]", "/3: is -1"}, Case{"[1000001, 0, 1, 1]", "/0: is 1000001"},
          Case{"[0, \"y\", 1, 1]", "/1: is \"y\""}, Case{"[0, 0, 1, [1]]", "/3: is a list"}}) {
        Reading const bad = readingOf(c.text);
        EXPECT_FALSE(bad.area) << c.text;
        ASSERT_EQ(bad.said.size(), 1U) << c.text;
        EXPECT_NE(bad.said[0].find(c.says), std::string::npos) << bad.said[0];
    }
    EXPECT_EQ(readingOf("[2000000, null, 0, 1]").said.size(), 3U) << "all errors are reported at once";
}

TEST(ReadArea, OtherValuesAreRefusedWithADescriptionOfBothForms) {
    for (char const* const text : {"3", "{}", "[]", "[1, 2]", "[1, 2, 3]", "[1, 2, 3, 4, 5]",
                                   "[[0, 0], [1, 1]]", "\"[0, 0, 1, 1]\"", "null"}) {
        Reading const bad = readingOf(text);
        EXPECT_FALSE(bad.area) << text;
        ASSERT_EQ(bad.said.size(), 1U) << text;
        EXPECT_NE(bad.said[0].find("a box [x, y, width, height] or a polygon"), std::string::npos)
            << bad.said[0];
    }
    Reading const mixed = readingOf("[[0, 0], 1, [1, 1], [2]]");
    EXPECT_FALSE(mixed.area);
    EXPECT_EQ(mixed.said.size(), 2U) << "one problem for each invalid corner";
}

/// The smallest extent of a set of points over many sampled directions.
double narrowest(std::vector<Vec2> const& points) {
    double least = HUGE_VAL;
    for (int i = 0; i < 3600; ++i) {
        double const angle = i * std::acos(-1.0) / 3600;
        Vec2 const across{std::cos(angle), std::sin(angle)};
        double low = HUGE_VAL;
        double high = -HUGE_VAL;
        for (Vec2 const p : points) {
            low = std::min(low, dot(p, across));
            high = std::max(high, dot(p, across));
        }
        least = std::min(least, high - low);
    }
    return least;
}

TEST(ReadArea, PolygonsAreReadAsStatedAndFlatOnesRefused) {
    EXPECT_TRUE(rc::check("wide polygons are taken, flat ones are not", [] {
        auto const coordinate = [] { return *rc::gen::inRange(-4000, 4001) / 1000.0; };
        std::vector<Vec2> corners;
        bool const onALine = *rc::gen::arbitrary<bool>();
        Vec2 const from{coordinate(), coordinate()};
        Vec2 const along{coordinate(), coordinate()};
        for (int i = *rc::gen::inRange(3, 8); i > 0; --i) {
            corners.push_back(onALine ? from + *rc::gen::inRange(0, 5) * along
                                      : Vec2{coordinate(), coordinate()});
        }
        Reading const read = readingOf(stated(corners));
        double const width = narrowest(corners);
        if (onALine) {
            RC_ASSERT(!read.area);
            RC_ASSERT(read.said.size() == 1);
            RC_ASSERT(read.said[0].find("is flat") != std::string::npos);
        } else if (width > 0.01) {
            RC_ASSERT(read.area.has_value());
            RC_ASSERT(!read.area->box);
            RC_ASSERT(read.area->corners == corners);
        }
    }));
}

TEST(ReadArea, APolygonHasALimitedNumberOfCorners) {
    auto const ring = [](std::size_t count) {
        std::vector<Vec2> corners;
        for (std::size_t i = 0; i < count; ++i) {
            double const angle = 2 * pi * static_cast<double>(i) / static_cast<double>(count);
            corners.push_back({100 * std::cos(angle), 100 * std::sin(angle)});
        }
        return stated(corners);
    };
    EXPECT_TRUE(readingOf(ring(limits::areaCorners)).area);
    Reading const many = readingOf(ring(limits::areaCorners + 1));
    EXPECT_FALSE(many.area);
    ASSERT_EQ(many.said.size(), 1U);
    EXPECT_NE(many.said[0].find("has 1001 entries; expected at most 1000"), std::string::npos);
}

} // namespace
} // namespace read_area_test
} // namespace trembler
