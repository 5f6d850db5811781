// Who touches whom, against brute force.
#include "physics/dynamics/engines/box2d/box2d_dynamics.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

namespace trembler::test {
namespace {

class ContactsTest : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(ContactsTest);

// A piece as a convex polygon (of one corner or more) and a radius around it, in the world.
struct Rounded {
    std::vector<Vec2> corners;
    double radius = 0;
};

Rounded roundedOf(ShapePiece const& piece, Vec2 at, double angle) {
    Rounded made;
    switch (piece.form) {
    case ShapeForm::circle:
        made = {{{0, 0}}, piece.radius};
        break;
    case ShapeForm::capsule: {
        double const half = piece.width / 2 - piece.radius;
        made = {{{-half, 0}, {half, 0}}, piece.radius};
        break;
    }
    case ShapeForm::box: {
        double const x = piece.width / 2;
        double const y = piece.height / 2;
        made = {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, 0};
        break;
    }
    case ShapeForm::polygon:
        made = {piece.corners, 0};
        break;
    }
    for (Vec2& corner : made.corners) {
        corner = at + rotated(piece.at + rotated(corner, piece.angle), angle);
    }
    return made;
}

double fromSegment(Vec2 point, Vec2 a, Vec2 b) {
    Vec2 const d = b - a;
    double const t = lengthSquared(d) == 0 ? 0 : std::clamp(dot(point - a, d) / lengthSquared(d), 0.0, 1.0);
    return length(point - a - t * d);
}

bool contains(std::vector<Vec2> const& corners, Vec2 point) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (cross(corners[(i + 1) % corners.size()] - corners[i], point - corners[i]) < 0) {
            return false;
        }
    }
    return corners.size() > 2;
}

// Gap between two pieces, in m; 0 or below where they overlap. Every corner against every side, no more.
double gap(Rounded const& a, Rounded const& b) {
    double least = 1e9;
    auto const crosses = [](Vec2 p, Vec2 q, Vec2 r, Vec2 s) {
        return cross(q - p, r - p) * cross(q - p, s - p) < 0 && cross(s - r, p - r) * cross(s - r, q - r) < 0;
    };
    for (auto const& [x, y] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
        for (Vec2 const corner : x->corners) {
            if (contains(y->corners, corner)) {
                return -1;
            }
            for (std::size_t i = 0; i < y->corners.size(); ++i) {
                Vec2 const next = y->corners[(i + 1) % y->corners.size()];
                least = std::min(least, fromSegment(corner, y->corners[i], next));
                for (std::size_t j = 0; j < x->corners.size(); ++j) {
                    if (crosses(x->corners[j], x->corners[(j + 1) % x->corners.size()], y->corners[i],
                                next)) {
                        return -1;
                    }
                }
            }
        }
    }
    return least - a.radius - b.radius;
}

double gap(Scene const& scene, ObjectId a, ObjectId b) {
    double least = 1e9;
    for (ShapePiece const& x : scene.world->find<Shape>(a)->pieces) {
        for (ShapePiece const& y : scene.world->find<Shape>(b)->pieces) {
            least = std::min(least, gap(roundedOf(x, scene.at(a), scene.angle(a)),
                                        roundedOf(y, scene.at(b), scene.angle(b))));
        }
    }
    return least;
}

ShapePiece randomPiece(Vec2 at) {
    double const size = *rc::gen::inRange(8, 40) * 0.01;
    switch (*rc::gen::inRange(0, 4)) {
    case 0:
        return circlePiece(size, at);
    case 1:
        return boxPiece(size, 0.1 + *rc::gen::inRange(0, 30) * 0.01, at, *rc::gen::inRange(0, 6) * 0.5);
    case 2:
        return capsulePiece(0.2 + size, 0.08, at, *rc::gen::inRange(0, 6) * 0.5);
    default:
        return polygonPiece({{0, 0}, {size, 0.05}, {0.1, size}}, at, *rc::gen::inRange(0, 6) * 1.0);
    }
}

using Pairs = std::set<std::pair<ObjectId, ObjectId>>;

Pairs pairsOf(std::vector<TouchingPair> const& list) {
    Pairs pairs;
    for (TouchingPair const& pair : list) {
        pairs.insert({pair.a, pair.b});
    }
    return pairs;
}

// What touches is what touched, less what ended, and what has begun; each list ascending, without repeats.
void expectConsistent(Contacts const& contacts, Pairs& known) {
    for (auto const* list : {&contacts.current, &contacts.begun, &contacts.ended, &contacts.brief}) {
        RC_ASSERT(std::is_sorted(list->begin(), list->end()));
        RC_ASSERT(pairsOf(*list).size() == list->size());
    }
    for (auto const& pair : pairsOf(contacts.brief)) {
        RC_ASSERT(!known.contains(pair) && !pairsOf(contacts.current).contains(pair));
    }
    for (auto const& pair : pairsOf(contacts.ended)) {
        RC_ASSERT(known.erase(pair) == 1U);
    }
    for (auto const& pair : pairsOf(contacts.begun)) {
        RC_ASSERT(known.insert(pair).second);
    }
    RC_ASSERT(known == pairsOf(contacts.current));
}

TEST_P(ContactsTest, AgreeWithBruteForceInRandomScenes) {
    EXPECT_TRUE(rc::check([] {
        Scene scene;
        scene.gravity = *rc::gen::element(0.0, 9.81);
        std::vector<ObjectId> all{scene.fixed("floor", boxPiece(6, 0.5), {0, -1})};
        int const count = *rc::gen::inRange(2, 14);
        for (int i = 0; i < count; ++i) {
            Shape shape{{randomPiece({})}};
            if (*rc::gen::inRange(0, 3) == 0) {
                shape.pieces.push_back(randomPiece({0.3, 0}));
            }
            Vec2 const at{*rc::gen::inRange(-15, 15) * 0.1, *rc::gen::inRange(0, 20) * 0.1};
            ObjectId const id = scene.body("body " + std::to_string(i), shape, at, i * 0.7);
            scene.give(id, Velocity{{*rc::gen::inRange(-10, 10) * 0.1, *rc::gen::inRange(-10, 10) * 0.1}});
            if (*rc::gen::inRange(0, 5) == 0) {
                scene.give(id, Fixed{});
            }
            all.push_back(id);
        }
        Pairs known;
        std::map<std::pair<ObjectId, ObjectId>, double> before;
        for (int frame = 0; frame < 60; ++frame) {
            scene.run(1);
            expectConsistent(scene.contacts(), known);
            for (std::size_t i = 0; i < all.size(); ++i) {
                for (std::size_t j = i + 1; j < all.size(); ++j) {
                    std::pair const pair{all[i], all[j]};
                    bool const bothFixed = scene.world->store().column<Fixed>().has(all[i]) &&
                                           scene.world->store().column<Fixed>().has(all[j]);
                    if (bothFixed) {
                        RC_ASSERT(!known.contains(pair));
                        continue;
                    }
                    // A touch is found where things are before a substep, and a gap of up to 0.01 m still is
                    // one.
                    double const now = gap(scene, all[i], all[j]);
                    double const was = before.contains(pair) ? before[pair] : 0;
                    before[pair] = now;
                    double const slack = 0.02 + std::abs(now - was);
                    if (now > slack) {
                        RC_ASSERT(!known.contains(pair));
                    }
                    if (now < -0.01 && was < -0.01) {
                        RC_ASSERT(known.contains(pair));
                    }
                }
            }
        }
    }));
}

TEST_P(ContactsTest, ACompoundTouchesOnceHoweverManyPiecesDo) {
    Scene scene;
    ObjectId const floor = scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
    Shape const table{
        {boxPiece(1, 0.1, {0, 0.5}), boxPiece(0.1, 0.5, {-0.4, 0.25}), boxPiece(0.1, 0.5, {0.4, 0.25})}};
    ObjectId const id = scene.body("table", table, {0, 0.02});
    std::size_t begun = 0;
    for (int frame = 0; frame < 60; ++frame) {
        scene.run(1);
        begun += scene.contacts().begun.size();
        ASSERT_TRUE(scene.contacts().ended.empty());
    }
    EXPECT_EQ(begun, 1U);
    EXPECT_TRUE(scene.touching(floor, id));
    // One foot lifts: the other still touches, so nothing ends.
    scene.of<Pull>(id).pointForce = {0, scene.mass(id) * 9.81 * 0.7};
    scene.of<Pull>(id).point = {0.4, 0.5};
    for (int frame = 0; frame < 10; ++frame) {
        scene.run(1);
        ASSERT_TRUE(scene.contacts().ended.empty());
    }
    EXPECT_GT(scene.angle(id), 0.01);
}

TEST_P(ContactsTest, EndWhenAnObjectGoesAndItsSleepingNeighboursWake) {
    Scene scene;
    ObjectId const floor = scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
    ObjectId const lower = scene.body("lower", boxPiece(0.5, 0.5), {0, 0.25});
    ObjectId const upper = scene.body("upper", boxPiece(0.5, 0.5), {0, 0.76});
    scene.run(200);
    ASSERT_EQ(scene.dynamics(), Activity::asleep);
    ASSERT_TRUE(scene.touching(lower, upper));
    scene.world->feed({.kind = PlayerInput::Kind::remove, .object = lower, .other = {}, .at = {}});
    Pairs ended;
    for (int frame = 0; frame < 5; ++frame) {
        scene.run(1);
        ended.merge(pairsOf(scene.contacts().ended));
    }
    EXPECT_TRUE(ended.contains({floor, lower}));
    EXPECT_TRUE(ended.contains({lower, upper}));
    scene.run(200);
    EXPECT_NEAR(scene.at(upper).y, 0.25, 0.02);
    EXPECT_TRUE(scene.touching(floor, upper));
    EXPECT_EQ(scene.dynamics(), Activity::asleep);
}

struct ReadsPatches final : Interaction<ReadsPatches, DynamicsRole, Reads<ContactPatches>> {
    static constexpr ComponentText text{
        .name = "Dynamics <- Patches", .effect = "test", .level = "", .work = "Looks."};
    using Activation = NeedsAll<>;
    void apply(Access&) {}
};

TEST_P(ContactsTest, PatchesCarryTheWeight) {
    for (double const scale : {1.0, 4.0}) {
        Scene scene({.solver = {.scale = scale, .sleeping = false},
                     .extend = [](Registry& r) { r.component<ReadsPatches>(); }});
        ObjectId const box = scene.body("box", boxPiece(0.5, 0.5), {0, 0.25});
        ObjectId const floor = scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
        scene.run(120);
        auto const& patches = scene.world->find<ContactPatches>()->patches;
        ASSERT_EQ(patches.size(), 1U);
        ContactPatch const& patch = patches[0];
        EXPECT_EQ(patch.a, box);
        EXPECT_EQ(patch.b, floor);
        EXPECT_NEAR(patch.normal.y, -1, 1e-3); // from a to b
        ASSERT_EQ(patch.count, 2);
        EXPECT_NEAR(std::abs(patch.points[0].x - patch.points[1].x), 0.5, 0.05); // skin included
        EXPECT_NEAR(patch.points[0].y, 0, 0.01);
        double const impulse = patch.normalImpulse[0] + patch.normalImpulse[1];
        EXPECT_NEAR(impulse, scene.mass(box) * 9.81 * frameDuration / 4, 0.02 * impulse);
    }
}

// The same engine under another name: to be swapped in.
class OtherDynamics final : public DynamicsResolver<OtherDynamics> {
public:
    static constexpr ComponentText text{.name = "Other Dynamics",
                                        .effect = "dynamics",
                                        .level = "other",
                                        .work = "The same once more.",
                                        .rank = 5};
    static constexpr EngineMaker engineMaker = makeBox2dEngine;
};

TEST(Swap, ContactsGoOnWhicheverEngineTakesOver) {
    std::vector<std::string> levels = engines();
    levels.emplace_back("other");
    EXPECT_TRUE(rc::check([&] {
        Scene scene({.extend = [](Registry& r) { r.component<OtherDynamics>(); }});
        scene.fixed("floor", boxPiece(6, 0.5), {0, -0.25});
        int const count = *rc::gen::inRange(1, 12);
        for (int i = 0; i < count; ++i) {
            scene.body("body " + std::to_string(i), randomPiece({}),
                       {*rc::gen::inRange(-10, 10) * 0.1, 0.3 + 0.4 * i});
        }
        Pairs known;
        for (int frame = 0; frame < 240; ++frame) {
            if (frame > 0 && *rc::gen::inRange(0, 20) == 0) {
                scene.world->setDetail("dynamics", *rc::gen::elementOf(levels));
            }
            scene.run(1);
            expectConsistent(scene.contacts(), known);
        }
    }));
}

TEST(Swap, APileThatRestsStaysWhereItIs) {
    Scene scene({.extend = [](Registry& r) { r.component<OtherDynamics>(); }});
    scene.fixed("floor", boxPiece(6, 0.5), {0, -0.25});
    std::vector<ObjectId> boxes;
    for (int i = 0; i < 5; ++i) {
        boxes.push_back(scene.body("box " + std::to_string(i), boxPiece(0.4, 0.4), {0, 0.2 + 0.41 * i}));
    }
    Joint joint;
    joint.a = scene.ball({2, 0.5});
    joint.at = {2, 1.5};
    ObjectId const bob = joint.a;
    scene.joint("pendulum", joint);
    scene.give(bob, Velocity{{1, 0}});
    scene.run(150);
    std::vector<Vec2> places;
    for (ObjectId const box : boxes) {
        places.push_back(scene.at(box));
    }
    // Engines differ in how deep things sink into each other, but not by more than their skins.
    std::vector<std::string> levels{"other", "box2d", "other"};
    for (std::string const& engine : engines()) {
        levels.push_back(engine);
    }
    for (std::string const& level : levels) {
        scene.world->setDetail("dynamics", level);
        scene.run(40);
        EXPECT_NEAR(length(scene.at(bob) - Vec2{2, 1.5}), 1, 2e-3); // the pin is where it was
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_NEAR(length(scene.at(boxes[i]) - places[i]), 0, 5 * 2.5e-3);
    }
}

} // namespace
} // namespace trembler::test
