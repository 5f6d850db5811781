// Cables, joints and contacts: their course and picking.
#include "physics/dynamics/properties/joint.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/motor/properties.hpp"
#include "render/draw/path.hpp"
#include "render/scene/objects/joints.hpp"
#include "render/scene/objects/wires.hpp"
#include "render/scene/overlays/overlay_contacts.hpp"
#include "tests/render/scene/scene_stage.hpp"

#include <rapidcheck.h>

#include <algorithm>

namespace trembler::render::test {
namespace {

Pose present(Facts const& facts) {
    return poseOf(facts);
}

Link const* find(std::vector<Link> const& links, ObjectId a, ObjectId b) {
    for (Link const& link : links) {
        if ((link.a == a && link.b == b) || (link.a == b && link.b == a)) {
            return &link;
        }
    }
    return nullptr;
}

// Whether the current of a link leaves `from`.
bool leaves(Link const& link, ObjectId from) {
    return (link.a == from) == link.forward;
}

TEST(SceneWires, AreDeadUntilTheCircuitIsClosed) {
    ExperimentStage stage;
    std::vector<Link> const before = linksOf(stage.world);
    ASSERT_EQ(before.size(), 5U);
    for (Link const& link : before) {
        EXPECT_FALSE(link.live);
        EXPECT_LT(link.a, link.b);
    }
    stage.closeSwitch();
    std::vector<Link> const after = linksOf(stage.world);
    ASSERT_EQ(after.size(), 7U);
    for (Link const& link : after) {
        EXPECT_TRUE(link.live);
    }
}

TEST(SceneWires, AreInsideAJointThatIsNotDrawnAndHoldsTheTwoTogether) {
    struct Case {
        JointForm form;
        JointDrawn drawn;
        bool inside;
    };
    for (Case const& tried :
         {Case{JointForm::weld, JointDrawn::none, true}, Case{JointForm::hinge, JointDrawn::none, true},
          Case{JointForm::weld, JointDrawn::own, false},
          Case{JointForm::rope, JointDrawn::none, false}}) { // as in the part "wire"
        ExperimentStage stage;
        ObjectId const first = stage.id["object 3"];
        ObjectId const second = stage.id["electromagnet"];
        ObjectId const made = stage.world.store().create("joint");
        stage.world.store().column<Joint>().set(
            made, Joint{.form = tried.form, .a = second, .b = first, .look = {.drawn = tried.drawn}});
        std::vector<Link> const links = linksOf(stage.world);
        ASSERT_NE(find(links, first, second), nullptr);
        for (Link const& link : links) {
            bool const joined = &link == find(links, first, second);
            EXPECT_EQ(link.inside, joined && tried.inside);
        }
    }
}

TEST(SceneWires, CurrentRunsFromTheSourceToTheReturn) {
    ExperimentStage stage;
    stage.closeSwitch();
    std::vector<Link> const links = linksOf(stage.world);
    std::vector<std::string> const way{"source",   "object 1",      "switch",   "object 2",
                                       "object 3", "electromagnet", "object 4", "earth"};
    for (std::size_t i = 1; i < way.size(); ++i) {
        Link const* const link = find(links, stage.id[way[i - 1]], stage.id[way[i]]);
        ASSERT_NE(link, nullptr) << way[i];
        EXPECT_TRUE(leaves(*link, stage.id[way[i - 1]])) << way[i];
    }
}

TEST(SceneWires, ACableHangsBetweenItsObjectsAndIsFoundThere) {
    ExperimentStage stage;
    FactsReader const reader(stage.world);
    Facts const a = reader.of(stage.id["object 2"]);
    Facts const b = reader.of(stage.id["object 3"]);
    std::vector<Point> const path = cablePath(a, poseOf(a), b, poseOf(b));
    EXPECT_LE(distanceTo(*a.shape, toLocal(poseOf(a), path.front())), 1e-9);
    EXPECT_LE(distanceTo(*b.shape, toLocal(poseOf(b), path.back())), 1e-9);
    Point const middle = path[path.size() / 2];
    EXPECT_LT(middle.y, 0.5 * (path.front().y + path.back().y)); // it sags
    Link const found = pickWire(stage.world, middle, 0.02);
    EXPECT_TRUE((found.a == a.id && found.b == b.id) || (found.a == b.id && found.b == a.id));
    EXPECT_FALSE(pickWire(stage.world, middle + Point{0.3, -0.3}, 0.02).a.valid());
}

TEST(SceneWires, OfAToolboxPictureHaveTheirWholeLengthAndMakeALoopIfTheyAreLong) {
    Point const from{-0.5, 0.2};
    Point const to{0.5, 0.2};
    for (double const length : {1.05, 1.5, 1.7, 2.4}) {
        std::vector<Point> const path = loopedCable(from, to, length);
        EXPECT_NEAR(pathLength(path), length, 0.01);
        EXPECT_EQ(path.front(), from);
        EXPECT_EQ(path.back(), to);
        bool back = false; // it runs back to the left where it makes a loop
        for (std::size_t i = 1; i < path.size(); ++i) {
            back = back || path[i].x < path[i - 1].x;
            EXPECT_LE(path[i].y, 0.2 + 1e-9) << "it lies below its ends";
        }
        EXPECT_EQ(back, length > 1.6) << length;
    }
}

TEST(SceneWires, OfAGeneratorLeadToItsSignAlthoughItConductsOnlyAtTimes) {
    ExperimentStage stage;
    Store& store = stage.world.store();
    ObjectId const own = stage.id["object 3"];
    auto const lineTo = [&](ObjectId source) {
        store.column<Generator>().set(own, Generator{.source = source});
        std::vector<Link> links = linksOf(stage.world);
        EXPECT_EQ(find(links, own, source), nullptr);
        addGeneratorLines(stage.world, links);
        Link const* const made = find(links, own, source);
        return made != nullptr && made->line && !made->live;
    };
    EXPECT_TRUE(lineTo(stage.id["source"])) << "a sign without a shape";
    EXPECT_FALSE(lineTo(stage.id["object 1"])) << "a terminal with a shape of its own stays as it is";
}

TEST(SceneWires, OfWhatTurnsLeaveThroughItsAxle) {
    for (bool const limited : {false, true}) {
        ExperimentStage stage;
        Store& store = stage.world.store();
        Vec2 const pivot{1.7, 0.4};
        auto const join = [&](std::string const& name, Joint const& joint) {
            store.column<Joint>().set(store.create(name), joint);
        };
        ObjectId const hub = stage.id["metal object"];
        join("axle", {.form = JointForm::hinge, .a = hub, .at = pivot, .limited = limited});
        join("first weld", {.form = JointForm::weld, .a = stage.id["object 3"], .b = hub});
        join("second weld", {.form = JointForm::weld, .a = hub, .b = stage.id["object 4"]});
        FactsReader const reader(stage.world);
        auto const passes = [&](std::string const& a, std::string const& b) {
            Facts const first = reader.of(stage.id[a]);
            Facts const second = reader.of(stage.id[b]);
            std::vector<Point> const path = cablePath(first, poseOf(first), second, poseOf(second));
            EXPECT_LE(distanceTo(*first.shape, toLocal(poseOf(first), path.front())), 1e-9);
            EXPECT_LE(distanceTo(*second.shape, toLocal(poseOf(second), path.back())), 1e-9);
            return std::any_of(path.begin(), path.end(), [&](Point at) {
                return length(at - Point{pivot.x, pivot.y}) < 1e-9;
            });
        };
        EXPECT_EQ(passes("object 3", "electromagnet"), !limited);
        EXPECT_EQ(passes("electromagnet", "object 4"), !limited);
        EXPECT_FALSE(passes("object 1", "electromagnet"));
        EXPECT_FALSE(passes("object 3", "object 4")) << "both turn with it";
    }
}

TEST(SceneWires, ContactsAreNoCables) {
    ExperimentStage stage;
    stage.closeSwitch();
    FactsReader const reader(stage.world);
    Facts const a = reader.of(stage.id["object 1"]);
    Facts const b = reader.of(stage.id["switch"]);
    std::vector<Point> const path = cablePath(a, poseOf(a), b, poseOf(b));
    Link const found = pickWire(stage.world, path[path.size() / 2], 0.01);
    EXPECT_FALSE(found.a == a.id && found.b == b.id);
}

TEST(SceneRopes, HaveTheirStatedLength) {
    EXPECT_TRUE(rc::check([] {
        double const rope = *rc::gen::inRange(100, 300) / 100.0;
        double const span = rope * *rc::gen::inRange(5, 100) / 100.0;
        double const angle = *rc::gen::inRange(-70, 71) / 100.0;
        Point const to{span * std::cos(angle), span * std::sin(angle)};
        double const drawn = pathLength(ropePath({}, to, rope));
        RC_ASSERT(std::abs(drawn - rope) < 0.002 * rope);
    }));
    EXPECT_EQ(ropePath({0, 0}, {1, 0}, 1).size(), 2U); // taut: straight
}

TEST(SceneJoints, StaysOnItsObjectsWhileTheySwing) {
    World world(everything());
    Store& store = world.store();
    store.column<GravityField>().set(store.create("world"), {{0, -9.81}});
    ObjectId const bar = body(world, "bar", {boxPiece(1, 0.1)}, {0.5, 0});
    ObjectId const pin = store.create("pin");
    Joint hinge;
    hinge.form = JointForm::hinge;
    hinge.a = bar;
    store.column<Joint>().set(pin, hinge);
    auto const before =
        placesOf(world, FactsReader(world), pin, present); // not started: at the level's places
    ASSERT_TRUE(before.has_value());
    EXPECT_EQ(before->a, Point{});
    world.start();
    for (int i = 0; i < 30; ++i) {
        world.step();
    }
    auto const after = placesOf(world, FactsReader(world), pin, present);
    ASSERT_TRUE(after.has_value());
    EXPECT_TRUE(after->toWorld);
    EXPECT_LT(length(after->a), 0.01);
    EXPECT_LT(length(after->b), 1e-9);
    EXPECT_LT(world.find<Rotation>(bar)->angle, -0.5); // it did swing
    store.destroy({bar});
    EXPECT_FALSE(placesOf(world, FactsReader(world), pin, present).has_value());
}

TEST(SceneContacts, ABoxOnTheFloorTouchesAtItsCorners) {
    Shape const floor{{boxPiece(10, 1)}};
    Shape const box{{boxPiece(0.6, 0.4)}};
    auto points = touchingPoints(floor, {{0, -0.5}, 0}, box, {{1, 0.2}, 0});
    ASSERT_EQ(points.size(), 2U);
    if (points[0].x > points[1].x) {
        std::swap(points[0], points[1]);
    }
    EXPECT_NEAR(points[0].x, 0.7, 1e-9);
    EXPECT_NEAR(points[1].x, 1.3, 1e-9);
    EXPECT_NEAR(points[0].y, 0, 1e-9);
    // Tilted, it touches at one corner.
    EXPECT_EQ(touchingPoints(floor, {{0, -0.5}, 0}, box, {{1, 0.33}, 0.5}).size(), 1U);
}

TEST(SceneContacts, ABallTouchesWhereItIsLowest) {
    auto const points =
        touchingPoints({{boxPiece(10, 1)}}, {{0, -0.5}, 0}, {{circlePiece(0.3)}}, {{1, 0.3}, 0});
    ASSERT_EQ(points.size(), 1U);
    EXPECT_NEAR(points[0].x, 1, 0.05);
    EXPECT_NEAR(points[0].y, 0, 0.002);
}

TEST(SceneContacts, PatchesAreShownOnlyWhileTheyAreComputed) {
    World world(everything());
    Store& store = world.store();
    store.column<GravityField>().set(store.create("world"), {{0, -9.81}});
    store.column<Fixed>().set(body(world, "floor", {boxPiece(10, 1)}, {0, -0.5}), {});
    ObjectId const box = body(world, "box", {boxPiece(0.6, 0.4)}, {-1, 0.2});
    world.start();
    for (int i = 0; i < 5; ++i) {
        world.step();
    }
    auto const draw = [&](bool overlay) {
        return picture({640, 480}, palette::paper, [&](Canvas& canvas) {
            if (overlay) {
                drawContacts(canvas, world);
            }
        });
    };
    Image const empty = draw(false);
    Image const marks = draw(true);
    EXPECT_NE(marks, empty);
    Subscription wantedContactPatches = world.want<ContactPatches>();
    store.column<Velocity>().set(box, {{2, 0}});
    for (int i = 0; i < 5; ++i) {
        world.step();
    }
    Image const patches = draw(true);
    EXPECT_NE(patches, marks);
    EXPECT_NE(patches, empty);
    wantedContactPatches.end();
    for (int i = 0; i < 60; ++i) { // it continues to slide while nothing reads the contacts
        store.column<Velocity>().set(box, {{2, 0}});
        world.step();
    }
    // The marks are at its present place: two metres farther.
    Image const now = draw(true);
    auto const painted = [&](double from, double to) {
        for (int y = 230; y < 250; ++y) {
            for (int x = static_cast<int>(320 + 100 * from); x < static_cast<int>(320 + 100 * to); ++x) {
                if (now.at(x, y) != empty.at(x, y)) {
                    return true;
                }
            }
        }
        return false;
    };
    EXPECT_TRUE(painted(0.3, 2.5));
    EXPECT_FALSE(painted(-2.5, -0.2));
}

} // namespace
} // namespace trembler::render::test
