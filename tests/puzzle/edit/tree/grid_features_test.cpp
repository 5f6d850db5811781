// What lies on the grid stays on it when it is dragged.
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/shapes.hpp"
#include "puzzle/edit/tree/grid_features.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace trembler::edit {
namespace grid_features_test {
namespace {

class Draw {
public:
    explicit Draw(unsigned seed) : engine_(seed) {}
    int whole(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
    }
    double number(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() % 100001) / 100000.0;
    }

private:
    std::mt19937 engine_;
};

/// A point on the grid or, one time in four, anywhere.
Vec2 point(Draw& draw, double step) {
    if (draw.whole(0, 3) == 0) {
        return {draw.number(-3, 3), draw.number(-3, 3)};
    }
    return {draw.whole(-40, 40) * step, draw.whole(-40, 40) * step};
}

Json drawnObject(Draw& draw, double step, std::string const& name) {
    DrawnShape drawn;
    Vec2 const at = point(draw, step);
    switch (draw.whole(0, 3)) {
    case 0:
        drawn = drawnBox(at, at + Vec2{draw.whole(1, 20) * step, draw.whole(1, 20) * step});
        break;
    case 1:
        drawn = drawnDisc(at, at + Vec2{draw.whole(1, 10) * step, 0});
        break;
    case 2:
        drawn = drawnCapsule(at, at + Vec2{draw.whole(1, 10) * step, draw.whole(0, 9) * step}, 0.05);
        break;
    default: { // a polygon about a point, which is concave at times
        std::vector<Vec2> corners;
        for (int i = 0, count = draw.whole(3, 7); i < count; ++i) {
            double const angle = 2 * std::numbers::pi * i / count;
            double const radius = draw.number(0.3, 1);
            Vec2 const corner = at + radius * Vec2{std::cos(angle), std::sin(angle)};
            corners.push_back({std::round(corner.x / step) * step, std::round(corner.y / step) * step});
        }
        try {
            drawn = drawnPolygon(corners);
        } catch (CommandError const&) { // corners coincide on a coarse grid
            drawn = drawnBox(at, at + Vec2{step, 2 * step});
        }
    }
    }
    constexpr std::array angles{0.0, 90.0, -90.0, 180.0, 37.0, 0.0};
    double const turned = angles[static_cast<std::size_t>(draw.whole(0, 5))];
    return {{"name", name},
            {"at", pointJson(drawn.at)},
            {"angle_deg", drawn.angleDegrees + turned},
            {"properties", {{"material", "wood"}, {"shape", drawn.shape}}}};
}

/// The corners of an entry's polygons and boxes, computed here from the file's own numbers.
std::vector<Vec2> cornersOf(Json const& entry) {
    std::vector<Vec2> corners;
    double const angle = entry["angle_deg"].get<double>() * std::numbers::pi / 180;
    Vec2 const at{entry["at"][0].get<double>(), entry["at"][1].get<double>()};
    auto const add = [&](Vec2 own) {
        corners.push_back(at + Vec2{std::cos(angle) * own.x - std::sin(angle) * own.y,
                                    std::sin(angle) * own.x + std::cos(angle) * own.y});
    };
    for (Json const& piece : entry["properties"]["shape"]) {
        if (piece["form"] == "box") {
            double const x = piece.value("width", 0.2) / 2;
            double const y = piece.value("height", 0.2) / 2;
            for (Vec2 const corner : {Vec2{x, y}, Vec2{-x, y}, Vec2{-x, -y}, Vec2{x, -y}}) {
                add(corner);
            }
        } else if (piece["form"] == "polygon") {
            for (Json const& corner : piece["corners"]) {
                add({corner[0].get<double>(), corner[1].get<double>()});
            }
        }
    }
    corners.push_back(at);
    return corners;
}

bool onGrid(double value, double step, double tolerance) {
    return std::abs(value - std::round(value / step) * step) < tolerance;
}

TEST(GridFeatures, WhatIsOnTheGridStaysThere) {
    Draw draw(36);
    int kept = 0;
    for (int round = 0; round < 300; ++round) {
        constexpr std::array steps{0.05, 0.1, 0.03, 0.25, 0.02};
        double const step = steps[static_cast<std::size_t>(draw.whole(0, 4))];
        Json level{{"version", 2}, {"title", "T"}, {"objects", Json::array()}};
        std::vector<std::string> names;
        for (int i = 0, count = draw.whole(1, 4); i < count; ++i) {
            names.push_back("object " + std::to_string(i));
            level["objects"].push_back(drawnObject(draw, step, names.back()));
        }
        GridFeatures const features = gridFeatures(editData(), level, names);
        Vec2 const dragged{draw.number(-2, 2), draw.number(-2, 2)};
        Vec2 const way{wayOnGrid(features.x, dragged.x, step), wayOnGrid(features.y, dragged.y, step)};
        EXPECT_LE(std::abs(way.x - dragged.x), step);
        EXPECT_LE(std::abs(way.y - dragged.y), step);
        Json moved = level;
        moveObjects(editData(), level, names, way).change(moved);
        bool anyX = false;
        bool anyY = false;
        for (std::size_t i = 0; i < names.size(); ++i) {
            auto const before = cornersOf(level["objects"][i]);
            auto const after = cornersOf(moved["objects"][i]);
            ASSERT_EQ(before.size(), after.size());
            for (std::size_t corner = 0; corner < before.size(); ++corner) {
                bool const x = onGrid(before[corner].x, step, 5e-8);
                bool const y = onGrid(before[corner].y, step, 5e-8);
                EXPECT_TRUE(!x || onGrid(after[corner].x, step, 2e-7)) << round;
                EXPECT_TRUE(!y || onGrid(after[corner].y, step, 2e-7)) << round;
                anyX |= x;
                anyY |= y;
                Vec2 const offset = after[corner] - before[corner];
                EXPECT_NEAR(offset.x, way.x, 1e-8) << "objects of a group keep their offsets";
                EXPECT_NEAR(offset.y, way.y, 1e-8);
            }
        }
        kept += anyX && anyY ? 1 : 0;
        // Dragged along one axis, it stays where it was along the other one, whatever that is.
        EXPECT_EQ(wayOnGrid(features.y, 0, step), 0);
        EXPECT_EQ(wayOnGrid(features.y, 0.4 * step, step), 0);
        EXPECT_EQ(wayOnGrid(features.x, -0.4 * step, step), 0);
    }
    EXPECT_GT(kept, 100);
}

TEST(GridFeatures, WhatIsNowhereOnTheGridComesToIt) {
    std::vector<double> const features{0.013, 0.152};
    EXPECT_NEAR(wayOnGrid(features, 0.1, 0.05), 0.098, 1e-12) << "0.152 goes to 0.25";
    EXPECT_NEAR(wayOnGrid(features, 0.14, 0.05), 0.137, 1e-12) << "0.013 goes to 0.15";
    EXPECT_EQ(wayOnGrid(features, 0.02, 0.05), 0);
    EXPECT_EQ(wayOnGrid({}, 0.12, 0.05), 0.1);
}

TEST(GridFeatures, ABoxOfOddWidthDoesNotSinkIntoTheFloor) {
    DrawnShape const box = drawnBox({0, 0}, {0.3, 0.95});
    Json const level{
        {"version", 2},
        {"title", "T"},
        {"objects", Json::array({{{"name", "box"},
                                  {"at", pointJson(box.at)},
                                  {"properties", {{"material", "wood"}, {"shape", box.shape}}}}})}};
    GridFeatures const features = gridFeatures(editData(), level, {"box"});
    EXPECT_EQ(features.y, (std::vector<double>{0, 0.475, 0.95}));
    EXPECT_NEAR(wayOnGrid(features.x, 0.43, 0.05), 0.45, 1e-12);
    EXPECT_EQ(wayOnGrid(features.y, 0.02, 0.05), 0);
    EXPECT_TRUE(gridFeatures(editData(), level, {"nobody"}).x.empty());
}

} // namespace
} // namespace grid_features_test
} // namespace trembler::edit
