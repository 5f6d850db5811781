// Belts around wheels, and pictures of ropes, chains and wires between two places.
#include "render/draw/path.hpp"
#include "render/scene/objects/ties.hpp"
#include "tests/render/stage.hpp"

#include <cmath>
#include <numbers>

namespace trembler::render::test {
namespace {

// Least distance of the path to a place.
double away(std::vector<Point> const& path, Point place) {
    double least = 1e9;
    for (std::size_t i = 1; i < path.size(); ++i) {
        Point const along = path[i] - path[i - 1];
        double const share =
            std::clamp(dot(place - path[i - 1], along) / std::max(dot(along, along), 1e-12), 0.0, 1.0);
        least = std::min(least, length(path[i - 1] + share * along - place));
    }
    return least;
}

TEST(Belt, RunsAroundBothWheelsWithoutCuttingThem) {
    BeltWheel const a{{-1, 0.2}, 0.5};
    BeltWheel const b{{1.2, -0.1}, 0.2};
    for (bool const crossed : {false, true}) {
        std::vector<Point> const path = beltPath(a, b, crossed);
        ASSERT_GT(path.size(), 10U);
        EXPECT_EQ(path.front(), path.back());
        EXPECT_NEAR(away(path, a.centre), a.radius, 0.01);
        EXPECT_NEAR(away(path, b.centre), b.radius, 0.01);
        EXPECT_LT(away(path, a.centre + Point{-0.5, 0}), 0.01) << "around the far side";
        EXPECT_LT(away(path, b.centre + Point{0.2, 0}), 0.01) << "around the far side";
    }
    // Two equal wheels: two straight pieces and two half circles.
    std::vector<Point> const even = beltPath({{0, 0}, 0.3}, {{2, 0}, 0.3}, false);
    EXPECT_NEAR(pathLength(even), 4 + 0.6 * std::numbers::pi, 0.01);
}

TEST(Belt, IsNotThereWhereWheelsOverlapTooMuch) {
    EXPECT_TRUE(beltPath({{0, 0}, 1}, {{0.5, 0}, 0.2}, false).empty()) << "one inside the other";
    EXPECT_TRUE(beltPath({{0, 0}, 1}, {{1.5, 0}, 0.6}, true).empty()) << "no room to cross";
    EXPECT_TRUE(beltPath({{0, 0}, 0}, {{1.5, 0}, 0.6}, false).empty());
    EXPECT_TRUE(beltPath({{0, 0}, 1}, {{std::nan(""), 0}, 0.6}, false).empty());
}

TEST(Tie, IsToldApartByItsLook) {
    std::vector<Point> const path{{-1, 0}, {0, -0.2}, {1, 0}};
    auto const pictureOf = [&](JointDrawn look, double moved = 0) {
        Image image =
            picture({240, 80}, palette::paper, [&](Canvas& canvas) { drawTie(canvas, look, path, moved); });
        return image;
    };
    std::vector<Image> seen{pictureOf(JointDrawn::none)};
    EXPECT_TRUE(pictureOf(JointDrawn::own) == seen.front());
    for (JointDrawn const look : {JointDrawn::rope, JointDrawn::cord, JointDrawn::chain, JointDrawn::belt,
                                  JointDrawn::rod, JointDrawn::spring, JointDrawn::wire}) {
        Image const image = pictureOf(look);
        keepForPeople(image, "tie-" + std::string(choiceNames<JointDrawn>[static_cast<std::size_t>(look)]));
        for (Image const& other : seen) {
            EXPECT_FALSE(image == other) << static_cast<int>(look);
        }
        seen.push_back(image);
    }
    EXPECT_FALSE(pictureOf(JointDrawn::belt, 0.03) == pictureOf(JointDrawn::belt)) << "it runs";
    EXPECT_FALSE(pictureOf(JointDrawn::chain, 0.03) == pictureOf(JointDrawn::chain)) << "it runs";
}

} // namespace
} // namespace trembler::render::test
