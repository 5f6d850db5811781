// Picking and bounds, against brute force and against the picture itself.
#include "render/scene/facts/pick.hpp"
#include "render/scene/scene_view.hpp"
#include "tests/render/scene/scene_stage.hpp"

#include <rapidcheck.h>

#include <numbers>

namespace trembler::render::test {
namespace pick_test {
namespace {

double between(double lower, double upper) {
    return lower + (upper - lower) * *rc::gen::inRange(0, 1000001) / 1e6;
}

// Depth of a point in a piece by its definition, written independently for the test: positive inside.
double depthIn(ShapePiece const& piece, Vec2 local) {
    Vec2 const p = rotated(local - piece.at, -piece.angle);
    switch (piece.form) {
    case ShapeForm::circle:
        return piece.radius - length(p);
    case ShapeForm::box:
        return std::min(piece.width / 2 - std::abs(p.x), piece.height / 2 - std::abs(p.y));
    case ShapeForm::capsule: {
        double const half = piece.width / 2 - piece.radius;
        Vec2 const nearest{std::clamp(p.x, -half, half), 0};
        return piece.radius - length(p - nearest);
    }
    case ShapeForm::polygon: {
        double least = 1e9;
        for (std::size_t i = 0; i < piece.corners.size(); ++i) {
            Vec2 const a = piece.corners[i];
            Vec2 const side = piece.corners[(i + 1) % piece.corners.size()] - a;
            least = std::min(least, cross(side, p - a) / length(side));
        }
        return least;
    }
    }
    return -1e9;
}

std::vector<ShapePiece> anyPieces() {
    switch (*rc::gen::inRange(0, 5)) {
    case 0:
        return {circlePiece(between(0.1, 0.6))};
    case 1:
        return {boxPiece(between(0.1, 2), between(0.1, 1))};
    case 2:
        return {capsulePiece(between(0.8, 2), 0.2)};
    case 3:
        return {polygonPiece({{-0.5, -0.3}, {0.6, -0.2}, {0.1, 0.5}})};
    default:
        return {boxPiece(1, 0.2), circlePiece(0.3, {0.5, 0}), boxPiece(0.3, 0.3, {-0.5, 0.1}, 0.6)};
    }
}

TEST(ScenePick, TopmostByBruteForce) {
    EXPECT_TRUE(rc::check([] {
        World world(everything());
        struct Placed {
            ObjectId id;
            Vec2 at;
            double angle;
            std::vector<ShapePiece> pieces;
            bool fixed;
        };
        std::vector<Placed> all;
        int const count = *rc::gen::inRange(1, 9);
        for (int i = 0; i < count; ++i) {
            Placed made{{},
                        {between(-2, 2), between(-2, 2)},
                        between(-4, 4),
                        anyPieces(),
                        *rc::gen::arbitrary<bool>()};
            made.id = body(world, "body " + std::to_string(i), made.pieces, made.at, made.angle);
            if (made.fixed) {
                world.store().column<Fixed>().set(made.id, {});
            }
            all.push_back(made);
        }
        for (int i = 0; i < 40; ++i) {
            Vec2 const p{between(-3, 3), between(-3, 3)};
            ObjectId expected;
            bool unsure = false;
            for (bool const fixed : {true, false}) { // from bottom to top
                for (Placed const& one : all) {
                    double depth = -1e9;
                    for (ShapePiece const& piece : one.pieces) {
                        depth = std::max(depth, depthIn(piece, rotated(p - one.at, -one.angle)));
                    }
                    if (one.fixed == fixed) {
                        expected = depth > 0 ? one.id : expected;
                        unsure = unsure || std::abs(depth) < 1e-9;
                    }
                }
            }
            RC_ASSERT(unsure || pick(world, toPoint(p)) == expected);
        }
    }));
}

TEST(ScenePick, TakesTheNearestWithinTheTolerance) {
    World world(everything());
    ObjectId const left = body(world, "left", {circlePiece(0.5)}, {-1, 0});
    ObjectId const right = body(world, "right", {boxPiece(1, 1)}, {1, 0});
    EXPECT_EQ(pick(world, {0.1, 0}, 0.05), ObjectId{});
    EXPECT_EQ(pick(world, {0.1, 0}, 0.45), right);
    EXPECT_EQ(pick(world, {-0.1, 0}, 0.45), left);
    EXPECT_EQ(pick(world, {-0.6, 0}, 0), left);
    EXPECT_EQ(pick(world, {std::nan(""), 0}, 0.5), ObjectId{});
}

TEST(ScenePick, AgreesWithThePicture) {
    ExperimentStage stage;
    // Without cables, whose pictures lie over the bodies.
    stage.world.store().column<ElectricityGraph>().removeAll(
        std::vector<ObjectId>(stage.world.store().column<ElectricityGraph>().owners().begin(),
                              stage.world.store().column<ElectricityGraph>().owners().end()));
    Camera const camera = stageCamera({1280, 720});
    auto const draw = [&](bool scene) {
        return picture(
            camera.viewport, palette::paper,
            [&](Canvas& canvas) {
                if (scene) {
                    drawScene(canvas, stage.world);
                }
            },
            {.shadows = false}, camera);
    };
    Image const empty = draw(false);
    Image const full = draw(true);
    int hits = 0;
    int misses = 0;
    for (int y = 3; y < 720; y += 7) {
        for (int x = 3; x < 1280; x += 7) {
            Point const at = camera.toWorld({x + 0.5, y + 0.5});
            double const pixels = 2.5 / camera.pixelsPerMetre;
            // Windings and flanges stand out of the electromagnet's shape a little.
            if (pick(stage.world, at, 0.09) == stage.id["electromagnet"]) {
                continue;
            }
            bool const inside = pick(stage.world, at).valid();
            bool const around = pick(stage.world, at, pixels).valid();
            if (inside != around) {
                continue; // on an edge
            }
            bool const deep = inside;
            bool const painted = full.at(x, y) != empty.at(x, y);
            // Within the width of the edge any colour is allowed; elsewhere it must not be that of the paper.
            EXPECT_EQ(painted, deep) << x << ", " << y;
            ++(deep ? hits : misses);
        }
    }
    EXPECT_GT(hits, 2000);
    EXPECT_GT(misses, 5000);
}

TEST(SceneBounds, CoverExactlyAllObjects) {
    World world(everything());
    EXPECT_TRUE(sceneFocus(world).empty());
    body(world, "bar", {boxPiece(2, 0.2)}, {1, 2}, std::numbers::pi / 2);
    body(world, "ball", {circlePiece(0.5)}, {-3, 0});
    Extent const bounds = sceneFocus(world);
    EXPECT_NEAR(bounds.lower.x, -3.5, 1e-12);
    EXPECT_NEAR(bounds.upper.x, 1.1, 1e-12);
    EXPECT_NEAR(bounds.lower.y, -0.5, 1e-12);
    EXPECT_NEAR(bounds.upper.y, 3, 1e-12);
}

TEST(SceneBounds, FocusLeavesOutTheFarEndsOfTheFloor) {
    World world(everything());
    body(world, "ball", {circlePiece(0.5)}, {3, 0.5});
    body(world, "crate", {boxPiece(1, 1)}, {-3, 0.5});
    ObjectId const floor = body(world, "floor", {boxPiece(2000, 1)}, {0, -0.5});
    world.store().column<Fixed>().set(floor, {});
    Extent const focus = sceneFocus(world);
    EXPECT_LE(focus.lower.x, -3.5);
    EXPECT_GE(focus.upper.x, 3.5);
    EXPECT_LT(focus.upper.x - focus.lower.x, 30);
    EXPECT_LT(focus.lower.y, 0); // some of the floor is seen
    Facts const whole = FactsReader(world).of(floor);
    EXPECT_NEAR(extentOf(whole, poseOf(whole)).upper.x, 1000, 1e-9);
}

TEST(SceneBounds, FocusLeavesOutWhatHasLeftTheBounds) {
    World world(everything());
    body(world, "crate", {boxPiece(1, 1)}, {-3, 0.5});
    Extent const crate = sceneFocus(world);
    ObjectId const balloon = body(world, "balloon", {circlePiece(0.2)}, {2, 3});
    Extent bounds;
    bounds.add(Point{-4, -1});
    bounds.add(Point{4, 4});
    EXPECT_NEAR(sceneFocus(world, bounds).upper.y, 3.2, 1e-12);
    world.store().column<Position>().set(balloon, {{2, 40}});
    EXPECT_EQ(sceneFocus(world, bounds).upper, crate.upper);
    EXPECT_NEAR(sceneFocus(world).upper.y, 40.2, 1e-12) << "where there are no bounds it counts";
    world.store().column<Fixed>().set(balloon, {});
    EXPECT_NEAR(sceneFocus(world, bounds).upper.y, 40.2, 1e-12) << "it was there from the start";
}

TEST(SceneBounds, APartHasTheExtentOfTheObjectThatItBecomes) {
    Prototype part;
    part.values.push_back(
        std::make_unique<ValueOf<Shape>>(Shape{{boxPiece(1, 0.2), circlePiece(0.3, {0.5, 0})}}));
    World world(everything());
    ObjectId const id = world.store().create("object");
    world.store().furnish(id, part);
    world.store().column<Position>().set(id, {{2, -1}});
    world.store().column<Rotation>().set(id, {0.7});
    Extent const ghost = extentOf(part, {{2, -1}, 0.7});
    EXPECT_EQ(ghost.lower, sceneFocus(world).lower);
    EXPECT_EQ(ghost.upper, sceneFocus(world).upper);
}

} // namespace
} // namespace pick_test
} // namespace trembler::render::test
