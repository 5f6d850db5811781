// Pictures of a world: what they must show, what they must not show, and that drawing does not change the
// world.
#include "render/scene/areas.hpp"
#include "render/scene/objects/body.hpp"
#include "render/scene/scene_view.hpp"
#include "runtime/input/input_resolver.hpp"
#include "tests/render/scene/scene_stage.hpp"

namespace trembler::render::test {
namespace scene_view_test {
namespace {

constexpr Size size{1280, 720};

Image draw(World const& world, SceneOptions const& options = {}, SceneView const& view = {}) {
    return picture(
        size, palette::paper,
        [&](Canvas& canvas) {
            canvas.paper();
            view.draw(canvas, world, options);
        },
        {}, stageCamera(size));
}

// How many pixels differ within `reach` pixels around a point of the world.
int changed(Image const& a, Image const& b, Point at, int reach) {
    Point const screen = stageCamera(size).toScreen(at);
    int count = 0;
    for (int y = static_cast<int>(screen.y) - reach; y <= static_cast<int>(screen.y) + reach; ++y) {
        for (int x = static_cast<int>(screen.x) - reach; x <= static_cast<int>(screen.x) + reach; ++x) {
            if (x >= 0 && y >= 0 && x < size.width && y < size.height) {
                count += a.at(x, y) != b.at(x, y) ? 1 : 0;
            }
        }
    }
    return count;
}

Point centreOf(std::vector<Point> const& path) {
    return path[path.size() / 2];
}

Point cableMiddle(ExperimentStage& stage, std::string const& a, std::string const& b) {
    FactsReader const reader(stage.world);
    Facts const from = reader.of(stage.id[a]);
    Facts const to = reader.of(stage.id[b]);
    return centreOf(cablePath(from, poseOf(from), to, poseOf(to)));
}

TEST(ScenePicture, AnExperimentAsAnExample) {
    ExperimentStage stage;
    keepForPeople(draw(stage.world), "scene-rest");
    stage.closeSwitch();
    keepForPeople(draw(stage.world, {.time = 0.3}), "scene-on");
    Size const large{3840, 2160};
    window().resize(large);
    keepForPeople(picture(
                      large, palette::paper,
                      [&](Canvas& canvas) {
                          canvas.paper();
                          drawScene(canvas, stage.world, {.time = 0.3, .overlays = {.electricity = true}});
                      },
                      {.uiScale = window().uiScale()}, stageCamera(large)),
                  "scene-on-2160");
}

TEST(ScenePicture, TheSameWorldGivesTheSamePicture) {
    ExperimentStage stage;
    stage.closeSwitch();
    EXPECT_EQ(draw(stage.world, {.time = 0.3}), draw(stage.world, {.time = 0.3}));
}

TEST(ScenePicture, AnObjectIsDrawnAtItsPosition) {
    ExperimentStage stage;
    Image const before = draw(stage.world);
    Vec2 const away{-0.5, 0.5};
    stage.world.store().column<Position>().set(stage.id["metal object"], {away});
    Image const after = draw(stage.world);
    EXPECT_GT(changed(before, after, {2.4, -2.22}, 20), 1500);  // it left this place
    EXPECT_GT(changed(before, after, toPoint(away), 20), 1500); // it is at this place now
    EXPECT_EQ(changed(before, after, {-4, 2}, 60), 0);
}

TEST(ScenePicture, CurrentLightsTheCable) {
    ExperimentStage stage;
    stage.closeSwitch();
    Image const on = draw(stage.world, {.time = 0.3});
    stage.world.store().slot<ElectricalState>().value() = {};
    Image const off = draw(stage.world, {.time = 0.3});
    Point const cable = cableMiddle(stage, "object 2", "object 3");
    EXPECT_GT(changed(on, off, cable, 10), 150);
    EXPECT_EQ(changed(on, off, {0, -2}, 60), 0); // no change at an empty place
    // The cable has the colour of current: much more red than blue around it.
    Point const screen = stageCamera(size).toScreen(cable);
    auto const warm = [&](Image const& image) {
        int sum = 0;
        for (int d = -6; d <= 6; ++d) {
            auto const pixel = image.at(static_cast<int>(screen.x), static_cast<int>(screen.y) + d);
            sum += pixel[0] - pixel[2];
        }
        return sum;
    };
    EXPECT_GT(warm(on), warm(off) + 500);
}

TEST(ScenePicture, CurrentMovesWithTimeAndOnlyWhereItIsOn) {
    ExperimentStage stage;
    EXPECT_EQ(draw(stage.world, {.time = 0}), draw(stage.world, {.time = 0.1}));
    stage.closeSwitch();
    Image const early = draw(stage.world, {.time = 0});
    Image const late = draw(stage.world, {.time = 0.1});
    EXPECT_GT(changed(early, late, cableMiddle(stage, "object 2", "object 3"), 12), 20);
    EXPECT_EQ(changed(early, late, {2.4, -2.2}, 40), 0);
}

TEST(ScenePicture, TheMagnetGlowsWhileItPulls) {
    ExperimentStage stage;
    Image const off = draw(stage.world);
    stage.world.store().column<Magnet>().set(stage.id["electromagnet"], {true, 1});
    Image const on = draw(stage.world);
    stage.world.store().column<Magnet>().set(stage.id["electromagnet"], {false, 0.5});
    Image const cooling = draw(stage.world);
    EXPECT_GT(changed(off, on, {2.4, 2.05}, 40), 2000);
    EXPECT_GT(changed(on, cooling, {2.4, 2.05}, 40), 2000);
    EXPECT_EQ(changed(off, on, {-3, 0}, 100), 0);
}

TEST(ScenePicture, OverlaysAreDrawnOnlyWhenAsked) {
    ExperimentStage stage;
    stage.closeSwitch();
    Store& store = stage.world.store();
    ObjectId const ball = stage.id["metal object"];
    store.slot<MagneticForce>().value().forces = {{ball, {2.4, 1.22}, {0, 300}, {}}};
    store.slot<Contacts>().value().current = {{stage.id["object 1"], stage.id["switch"], {}}};
    Image const plain = draw(stage.world);
    auto const with = [&](Overlays const& overlays) { return draw(stage.world, {.overlays = overlays}); };
    EXPECT_EQ(with({}), plain);
    EXPECT_GT(changed(with({.electricity = true}), plain, {-2.7, -0.6}, 80), 500);
    EXPECT_GT(changed(with({.forces = true}), plain, {2.4, 1.6}, 30), 60);
    EXPECT_GT(changed(with({.fieldLines = true}), plain, {2.4, 0}, 200), 300);
    EXPECT_GT(changed(with({.contacts = true}), plain, {-3.5, -0.68}, 40), 40);
    // Each overlay changes only its own pixels.
    EXPECT_EQ(changed(with({.contacts = true}), plain, {2.4, 1.5}, 60), 0);
    EXPECT_EQ(changed(with({.forces = true}), plain, {-3.5, -0.68}, 60), 0);
    store.slot<MagneticForce>().value().forces.clear();
    EXPECT_EQ(with({.forces = true}), plain);
}

TEST(ScenePicture, SelectionAndHoverAreSeen) {
    ExperimentStage stage;
    Image const plain = draw(stage.world);
    ObjectId const bar = stage.id["switch"];
    EXPECT_GT(changed(draw(stage.world, {.selected = bar}), plain, {-2.7, 0.6}, 60), 200);
    EXPECT_GT(changed(draw(stage.world, {.hovered = bar}), plain, {-2.7, 0.6}, 60), 200);
    EXPECT_EQ(changed(draw(stage.world, {.selected = bar}), plain, {2.4, -2.2}, 60), 0);
    // An invalid id selects nothing.
    EXPECT_EQ(draw(stage.world, {.selected = ObjectId{9999, 3}}), plain);
}

TEST(ScenePicture, AreasAndGoalsAreDrawnAtTheirPlaces) {
    ExperimentStage stage;
    Image const plain = draw(stage.world);
    std::vector<Area> const placing{{Box{{-0.9, -0.5}, {1, 1}}, {}}};
    GoalRegion goal{{std::nullopt, {{0.5, -2}, {1.5, -2}, {1.5, -1}, {1, -1.5}, {0.5, -1}}}, false};
    Image const open = draw(stage.world, {.placing = placing, .goals = {&goal, 1}});
    EXPECT_GT(changed(open, plain, {-0.4, 0}, 40), 1000);
    EXPECT_GT(changed(open, plain, {1, -1.8}, 10), 100);
    EXPECT_EQ(changed(open, plain, {1, -1.1}, 5), 0); // outside, in the notch
    EXPECT_EQ(changed(open, plain, {-4, 2}, 40), 0);
    goal.met = true;
    EXPECT_GT(changed(draw(stage.world, {.placing = placing, .goals = {&goal, 1}}), open, {1, -1.8}, 10),
              100);
}

TEST(ScenePicture, AGhostShowsWhetherItMayBePlaced) {
    ExperimentStage stage;
    Prototype part;
    part.values.push_back(std::make_unique<ValueOf<Shape>>(Shape{{boxPiece(0.8, 0.2), boxPiece(0.2, 0.8)}}));
    auto const ghost = [&](bool allowed) {
        return picture(
            size, palette::paper,
            [&](Canvas& canvas) {
                canvas.paper();
                drawGhost(canvas, part, {{0, 0}, 0.3}, allowed);
            },
            {}, stageCamera(size));
    };
    Image const empty = picture(
        size, palette::paper, [](Canvas& canvas) { canvas.paper(); }, {}, stageCamera(size));
    EXPECT_GT(changed(ghost(true), empty, {}, 40), 2000);
    EXPECT_GT(changed(ghost(false), ghost(true), {}, 40), 2000);
}

TEST(ScenePicture, DrawingNeverChangesTheWorld) {
    ExperimentStage stage;
    stage.closeSwitch();
    stage.world.start();
    stage.world.step();
    stage.world.feed(
        {.kind = PlayerInput::Kind::grab, .object = stage.id["switch"], .other = {}, .at = {-2, -0.5}});
    stage.world.step();
    Store const& store = stage.world.store();
    auto const versions = [&] {
        std::vector<std::uint64_t> all{stage.world.stateHash(), store.structureVersion()};
        for (ColumnBase const* column : store.columns()) {
            all.push_back(column->version());
        }
        return all;
    };
    auto const before = versions();
    SceneView view;
    view.remember(stage.world);
    Overlays const everythingOn{true, true, true, true};
    draw(stage.world, {.alpha = 0.5, .selected = stage.id["switch"], .overlays = everythingOn}, view);
    (void)pick(stage.world, {0, 0}, 1);
    (void)pickWire(stage.world, {0, 0}, 1);
    (void)sceneFocus(stage.world);
    (void)view.labels(stage.world);
    EXPECT_EQ(versions(), before);
}

TEST(ScenePicture, TheHandsCordIsSeenWhileItHolds) {
    ExperimentStage stage;
    stage.world.start();
    stage.world.step();
    stage.world.feed(
        {.kind = PlayerInput::Kind::grab, .object = stage.id["switch"], .other = {}, .at = {-2, 0.6}});
    stage.world.feed({.kind = PlayerInput::Kind::move, .object = {}, .other = {}, .at = {-1, 1.8}});
    stage.world.step();
    Image const held = draw(stage.world);
    stage.world.store().slot<Hand>().value() = {};
    Image const free = draw(stage.world);
    EXPECT_GT(changed(held, free, {-1, 1.8}, 15), 100);   // the hand
    EXPECT_GT(changed(held, free, {-1.4, 1.32}, 30), 50); // the cord
}

TEST(SceneView, InterpolatesBetweenTwoFrames) {
    World world(everything());
    ObjectId const ball = body(world, "ball", {circlePiece(0.3)}, {0, 0});
    SceneView view;
    view.remember(world);
    world.store().column<Position>().set(ball, {{1, 2}});
    world.store().column<Rotation>().set(ball, {0.4});
    EXPECT_EQ(view.poseOf(world, ball, 0).at, (Point{0, 0}));
    EXPECT_EQ(view.poseOf(world, ball, 1).at, (Point{1, 2}));
    EXPECT_NEAR(view.poseOf(world, ball, 0.25).at.y, 0.5, 1e-12);
    EXPECT_NEAR(view.poseOf(world, ball, 0.25).angle, 0.1, 1e-12);
    EXPECT_EQ(view.poseOf(world, ball, 7).at, (Point{1, 2}));
    view.start();
    EXPECT_EQ(view.poseOf(world, ball, 0.25).at, (Point{1, 2}));
}

TEST(SceneView, DoesNotInterpolateMovesByTheLevelOrThePlayer) {
    World world(everything());
    ObjectId const ball = body(world, "ball", {circlePiece(0.3)}, {0, 0});
    SceneView view;
    view.remember(world);
    world.store().column<Position>().set(ball, {{500, 0}});
    EXPECT_EQ(view.poseOf(world, ball, 0.5).at, (Point{500, 0})); // no body is that fast
    world.store().destroy({ball});
    ObjectId const stranger = body(world, "stranger", {circlePiece(0.3)}, {2, 0});
    ASSERT_EQ(stranger.index, ball.index);
    EXPECT_EQ(view.poseOf(world, stranger, 0.5).at,
              (Point{2, 0})); // the previous place belonged to another object
}

TEST(SceneView, ReturnsTheLabelsOfObjects) {
    World world(everything());
    ObjectId const crate = body(world, "crate", {boxPiece(1, 0.5)}, {3, 1});
    world.store().column<Look>().set(crate, {LookPattern::wood, "", "XII"});
    ObjectId const battery = body(world, "battery", {boxPiece(0.4, 0.4)}, {0, 0});
    world.store().column<Look>().set(battery, {LookPattern::gold, "", "+"});
    world.store().column<ElectricalSource>().set(battery, {}); // carries the sign already
    body(world, "ball", {circlePiece(0.3)}, {0, 3});
    auto const labels = SceneView().labels(world);
    ASSERT_EQ(labels.size(), 1U);
    EXPECT_EQ(labels[0].text, "XII");
    EXPECT_EQ(labels[0].at, (Point{3, 1}));
    EXPECT_GT(labels[0].metresHigh, 0.1);
    EXPECT_LT(labels[0].metresHigh, 0.5);
}

TEST(ScenePicture, SurvivesExtremeStatesOfSimulations) {
    ExperimentStage stage;
    stage.closeSwitch();
    double const nan = std::nan("");
    stage.world.store().column<Position>().set(stage.id["switch"], {{nan, 1e300}});
    stage.world.store().column<Position>().set(stage.id["metal object"], {{1e300, -1e300}});
    stage.world.store().column<Rotation>().set(stage.id["object 2"], {nan});
    stage.world.store().column<MagneticStrength>().set(stage.id["electromagnet"], {1e300, 0});
    Overlays const everythingOn{true, true, true, true};
    Image const image = draw(stage.world, {.selected = stage.id["switch"], .overlays = everythingOn});
    EXPECT_EQ(image.size(), size);
    EXPECT_FALSE(sceneFocus(stage.world).empty());
    (void)pick(stage.world, {0, 0}, 1);
}

} // namespace
} // namespace scene_view_test
} // namespace trembler::render::test
