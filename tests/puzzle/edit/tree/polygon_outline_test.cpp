// The outline of shapes made of polygons, found again from their convex pieces.
#include "puzzle/edit/commands/shapes.hpp"
#include "puzzle/edit/tree/convex_pieces.hpp"
#include "puzzle/edit/tree/polygon_outline.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace trembler::edit {
namespace polygon_outline_test {
namespace {

/// A star-shaped polygon around the origin, concave at times, anticlockwise.
std::vector<Vec2> randomPolygon(std::mt19937& engine) {
    int const count = 3 + static_cast<int>(engine() % 9);
    std::vector<Vec2> corners;
    for (int i = 0; i < count; ++i) {
        double const angle = 2 * std::numbers::pi * i / count;
        double const radius = 0.3 + static_cast<double>(engine() % 1000) / 1000.0;
        corners.push_back(radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    return corners;
}

Shape shapeFrom(std::vector<std::vector<Vec2>> const& pieces) {
    Shape shape;
    for (std::vector<Vec2> const& piece : pieces) {
        shape.pieces.push_back(polygonPiece(piece));
    }
    return shape;
}

TEST(PolygonOutline, IsThatFromWhichThePiecesWereMade) {
    std::mt19937 engine(5);
    int concave = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec2> const corners = randomPolygon(engine);
        ConvexPieces const pieces = convexPieces(corners);
        concave += pieces.pieces.size() > 1 ? 1 : 0;
        auto const outline = polygonOutline(shapeFrom(pieces.pieces));
        ASSERT_TRUE(outline) << round;
        ASSERT_EQ(outline->size(), corners.size()) << round;
        // The same corners in the same order, from another one on.
        std::size_t shift = 0;
        while (shift < corners.size() && length(corners[shift] - outline->front()) > 1e-6) {
            ++shift;
        }
        ASSERT_LT(shift, corners.size()) << round;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            EXPECT_LT(length((*outline)[i] - corners[(i + shift) % corners.size()]), 1e-6) << round;
        }
    }
    EXPECT_GT(concave, 50);
}

TEST(PolygonOutline, OtherShapesHaveNone) {
    EXPECT_FALSE(polygonOutline(Shape{{boxPiece(1, 1)}}));
    EXPECT_FALSE(polygonOutline(Shape{}));
    std::vector<Vec2> const square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::vector<Vec2> const apart{{3, 0}, {4, 0}, {4, 1}, {3, 1}};
    EXPECT_TRUE(polygonOutline(shapeFrom({square})));
    EXPECT_FALSE(polygonOutline(shapeFrom({square, apart})));
}

TEST(PolygonOutline, ACornerOfAnObjectIsMovedInTheWorld) {
    std::mt19937 engine(7);
    for (int round = 0; round < 50; ++round) {
        std::vector<Vec2> const corners = randomPolygon(engine);
        DrawnShape const drawn = drawnPolygon(corners);
        double const turned = 30.0 * static_cast<double>(engine() % 12);
        Json const level{
            {"version", 2},
            {"title", "T"},
            {"objects", Json::array({{{"name", "plate"},
                                      {"at", pointJson(drawn.at)},
                                      {"angle_deg", turned},
                                      {"properties", {{"material", "wood"}, {"shape", drawn.shape}}}}})}};
        std::vector<Vec2> const before = outlineCorners(editData(), level, "plate");
        ASSERT_EQ(before.size(), corners.size());
        std::size_t const which = engine() % before.size();
        Vec2 const to = before[which] * 1.2 - 0.2 * drawn.at; // outwards
        Json changed = level;
        moveCorner(editData(), level, "plate", which, to).change(changed);
        EXPECT_EQ(changed["objects"][0]["at"], level["objects"][0]["at"]);
        std::vector<Vec2> const after = outlineCorners(editData(), changed, "plate");
        auto const has = [&](Vec2 corner) {
            return std::any_of(after.begin(), after.end(),
                               [&](Vec2 one) { return length(one - corner) < 1e-6; });
        };
        EXPECT_TRUE(has(to)) << round;
        for (std::size_t i = 0; i < before.size(); ++i) {
            // Corners that come to lie on the line between their neighbours are left out.
            EXPECT_TRUE(i == which || after.size() < before.size() || has(before[i])) << round;
        }
    }
}

TEST(PolygonOutline, ImpossibleCornersAreRefused) {
    DrawnShape const drawn = drawnPolygon(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    Json level{{"version", 2},
               {"title", "T"},
               {"objects", Json::array({{{"name", "plate"},
                                         {"at", pointJson(drawn.at)},
                                         {"properties", {{"material", "wood"}, {"shape", drawn.shape}}}}})}};
    auto const refused = [&](std::size_t corner, Vec2 to) {
        return refusalOf([&] { static_cast<void>(moveCorner(editData(), level, "plate", corner, to)); });
    };
    EXPECT_EQ(refused(0, {-1, -1}), "");
    EXPECT_NE(refused(4, {0, 0}), "") << "there are four";
    std::vector<Vec2> const corners = outlineCorners(editData(), level, "plate");
    Vec2 const across = corners[2] + (corners[1] - corners[0]) - 0.5 * (corners[2] - corners[1]);
    EXPECT_NE(refused(0, across), "") << "edges cross";
    level["editor"]["locked"] = Json::array({"plate"});
    EXPECT_NE(refused(0, {-1, -1}), "") << "it is locked";
}

} // namespace
} // namespace polygon_outline_test
} // namespace trembler::edit
