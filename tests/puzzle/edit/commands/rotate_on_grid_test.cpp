// Turning keeps corners on the grid, over boxes of odd and even sizes, and returns to where it began.
#include "puzzle/edit/commands/rotate_on_grid.hpp"
#include "puzzle/edit/tree/extent.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace trembler::edit {
namespace rotate_on_grid_test {
namespace {

constexpr double step = 0.05; // m

Json box(std::string const& name, Vec2 corner, double width, double height, double angle = 0) {
    Vec2 const middle = corner + 0.5 * Vec2{width, height};
    return {{"name", name},
            {"at", {middle.x, middle.y}},
            {"angle_deg", angle},
            {"properties",
             {{"material", "wood"},
              {"shape", Json::array({{{"form", "box"}, {"width", width}, {"height", height}}})}}}};
}

Json levelOf(std::vector<Json> const& objects) {
    return {{"version", 2}, {"title", "Boxes"}, {"objects", objects}};
}

Json turned(Json level, std::vector<std::string> const& names, double degrees) {
    Box const around = *extentOfObjects(editData(), level, names);
    rotateOnGrid(editData(), level, names, degrees, around.corner + 0.5 * around.size, step).change(level);
    return level;
}

/// How far a length is from the grid, m.
double offGrid(double value) {
    return std::abs(value - std::round(value / step) * step);
}

double offGrid(Box const& box) {
    Vec2 const high = box.corner + box.size;
    return std::max({offGrid(box.corner.x), offGrid(box.corner.y), offGrid(high.x), offGrid(high.y)});
}

TEST(RotateOnGrid, KeepsTheCornersOfBoxesOfOddAndEvenSizes) {
    for (int width = 1; width <= 6; ++width) {
        for (int height = 1; height <= 6; ++height) {
            for (double const degrees : {90.0, -90.0, 15.0, 45.0}) {
                Json const start = levelOf({box("box", {0.35, -0.6}, width * step, height * step)});
                Box const before = *extentOfObjects(editData(), start, {"box"});
                Json level = start;
                double angle = 0;
                for (int i = 0; i < std::lround(360 / std::abs(degrees)); ++i) {
                    level = turned(level, {"box"}, degrees);
                    angle += degrees;
                    if (std::remainder(angle, 90) != 0) {
                        continue;
                    }
                    std::string const what = std::to_string(width) + " x " + std::to_string(height) + " by " +
                                             std::to_string(degrees) + " to " + std::to_string(angle);
                    Box const now = *extentOfObjects(editData(), level, {"box"});
                    EXPECT_LT(offGrid(now), 1e-7) << what;
                    Vec2 const moved = now.corner + 0.5 * now.size - before.corner - 0.5 * before.size;
                    EXPECT_LE(std::max(std::abs(moved.x), std::abs(moved.y)), 0.5 * step + 1e-7) << what;
                }
                Box const after = *extentOfObjects(editData(), level, {"box"});
                EXPECT_NEAR(length(after.corner - before.corner), 0, 1e-7) << width << " x " << height;
            }
        }
    }
}

TEST(RotateOnGrid, MovesSeveralObjectsTogether) {
    Json const start = levelOf(
        {box("a", {0, 0}, 0.15, 0.1), box("b", {0.15, 0.05}, 0.2, 0.05), box("c", {0, 0.1}, 0.1, 0.25)});
    std::vector<std::string> const all{"a", "b", "c"};
    Json level = start;
    for (int i = 0; i < 4; ++i) {
        level = turned(level, all, 90);
        for (std::string const& name : all) {
            EXPECT_LT(offGrid(*extentOfObjects(editData(), level, {name})), 1e-7) << name << " after " << i;
        }
    }
    for (std::string const& name : all) {
        Box const before = *extentOfObjects(editData(), start, {name});
        Box const after = *extentOfObjects(editData(), level, {name});
        EXPECT_NEAR(length(after.corner - before.corner), 0, 1e-7) << name;
    }
}

TEST(RotateOnGrid, OnlyTurnsWhatWasNotOnTheGrid) {
    for (Vec2 const corner : {Vec2{0.013, 0}, Vec2{0.025, 0.025}, Vec2{0.025, 0}}) {
        Json const start = levelOf({box("box", corner, 0.15, 0.15), box("flat", corner, 0.2, 0.1)});
        for (char const* const name : {"box", "flat"}) {
            Box const before = *extentOfObjects(editData(), start, {name});
            Box const after = *extentOfObjects(editData(), turned(start, {name}, 90), {name});
            EXPECT_NEAR(length(after.corner + 0.5 * after.size - before.corner - 0.5 * before.size), 0, 1e-9)
                << name << " at " << corner.x;
        }
    }
}

} // namespace
} // namespace rotate_on_grid_test
} // namespace trembler::edit
