// Loads of joints: closed forms for chains and bridges, and arbitrary graphs compared with removing each
// joint in turn.
#include "physics/dynamics/core/demand/joint_graph.hpp"
#include "tests/physics/dynamics/core/demand/tied_bodies.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace trembler::test {
namespace joint_graph_test {
namespace {

std::vector<JointLoad> loadsIn(TiedBodies const& tied) {
    return jointLoads(tied.columns(), tied.bodies(), tied.joints(), tied.loads());
}

TEST(JointGraph, EveryLinkOfAChainCarriesTheLinksBelowIt) {
    TiedBodies tied;
    std::vector<ObjectId> joints;
    ObjectId above;
    constexpr int links = 9;
    for (int i = 0; i < links; ++i) {
        ObjectId const link = tied.body({0, -0.5 - i}, 1 + i);
        joints.push_back(tied.joint(JointForm::hinge, link, above, {0, -1.0 * i}));
        above = link;
    }
    tied.weigh({0, -10});
    tied.settle();
    std::vector<JointLoad> const found = loadsIn(tied);
    for (int i = 0; i < links; ++i) {
        double mass = 0;
        double moment = 0;
        for (int below = i; below < links; ++below) {
            mass += 1 + below;
            moment += (1 + below) * (-0.5 - below);
        }
        JointLoad const& load = found[tied.slotOf(joints[static_cast<std::size_t>(i)])];
        EXPECT_TRUE(load.alone);
        EXPECT_NEAR(load.mass, mass, 1e-12);
        EXPECT_NEAR(load.pull, 10 * mass, 1e-11);
        EXPECT_NEAR(load.centre.y, moment / mass, 1e-12);
    }
}

TEST(JointGraph, BodiesThatHangSideBySideFromTheGroundAreSeparate) {
    TiedBodies tied;
    ObjectId const wall = tied.fixed({0, 5});
    ObjectId const light = tied.body({-1, 0}, 2);
    ObjectId const heavy = tied.body({1, 0}, 300);
    ObjectId const one = tied.joint(JointForm::rope, light, wall, {-1, 1});
    ObjectId const two = tied.joint(JointForm::rope, heavy, {}, {1, 1});
    tied.weigh({0, -10});
    tied.settle();
    std::vector<JointLoad> const found = loadsIn(tied);
    EXPECT_EQ(found[tied.slotOf(one)].pull, 20);
    EXPECT_EQ(found[tied.slotOf(two)].pull, 3000);
}

// The world and all fixed bodies count as one: bodies held by two walls are part of a loop.
TEST(JointGraph, ABridgeBetweenTwoWallsIsALoopWhoseJointsMayCarryAllForces) {
    TiedBodies tied;
    ObjectId const left = tied.fixed({-5, 0});
    ObjectId const a = tied.body({-1, 0}, 2);
    ObjectId const b = tied.body({1, 0}, 3);
    std::vector<ObjectId> const joints{tied.joint(JointForm::hinge, a, left, {-2, 0}),
                                       tied.joint(JointForm::hinge, a, b, {0, 0}),
                                       tied.joint(JointForm::hinge, b, {}, {2, 0})};
    tied.pull(a, {30, 40}); // opposite to the other force, but the two do not cancel
    tied.pull(b, {-30, -40});
    tied.settle();
    for (JointLoad const& load : loadsIn(tied)) {
        EXPECT_FALSE(load.alone);
        EXPECT_EQ(load.mass, 5);
        EXPECT_EQ(load.pull, 100);
    }
}

TEST(JointGraph, InFreeFallTheLighterSideHangsOnTheHeavier) {
    TiedBodies tied;
    ObjectId const light = tied.body({0, 0}, 1);
    ObjectId const heavy = tied.body({4, 0}, 9);
    ObjectId const joint = tied.joint(JointForm::weld, heavy, light, {1, 0});
    tied.pull(light, {3, 4});
    tied.pull(heavy, {1000, 0});
    tied.settle();
    JointLoad const load = loadsIn(tied)[tied.slotOf(joint)];
    EXPECT_TRUE(load.alone);
    EXPECT_EQ(load.mass, 1);
    EXPECT_EQ(load.pull, 5);
    EXPECT_EQ(load.centre, (Vec2{0, 0}));
}

TEST(JointGraph, SpringsAndGearsCarryNoLoadAndCloseNoLoop) {
    TiedBodies tied;
    ObjectId const a = tied.body({0, 0}, 1);
    ObjectId const b = tied.body({1, 0}, 1);
    ObjectId const pinA = tied.joint(JointForm::hinge, a, {}, {0, 0});
    ObjectId const pinB = tied.joint(JointForm::hinge, b, {}, {1, 0});
    Joint gear;
    gear.form = JointForm::gear;
    gear.a = a;
    gear.b = b;
    gear.jointA = pinA;
    gear.jointB = pinB;
    gear.ratio = 1;
    ObjectId const teeth = tied.joint(gear);
    ObjectId const spring = tied.joint(JointForm::spring, a, b, {0.5, 0});
    tied.weigh({0, -10});
    tied.settle();
    std::vector<JointLoad> const found = loadsIn(tied);
    for (ObjectId const none : {teeth, spring}) {
        EXPECT_EQ(found[tied.slotOf(none)].mass, 0);
        EXPECT_EQ(found[tied.slotOf(none)].pull, 0);
    }
    for (ObjectId const pin : {pinA, pinB}) {
        EXPECT_TRUE(found[tied.slotOf(pin)].alone);
        EXPECT_EQ(found[tied.slotOf(pin)].pull, 10);
    }
}

TEST(JointGraph, FreeSlotsAndBodiesWithoutLoadsAddNoLoad) {
    TiedBodies tied;
    ObjectId const a = tied.body({0, 0}, 1);
    ObjectId const b = tied.body({0, -1}, 1);
    ObjectId const gone = tied.joint(JointForm::hinge, a, {}, {0, 0});
    ObjectId const held = tied.joint(JointForm::hinge, a, b, {0, -0.5});
    tied.settle();
    tied.remove(gone);
    tied.settle();
    ASSERT_EQ(tied.joints().joints().size(), 2U);
    std::vector<JointLoad> const found = jointLoads(tied.columns(), tied.bodies(), tied.joints(), {});
    EXPECT_EQ(found[1 - tied.slotOf(held)].mass, 0);
    EXPECT_EQ(found[tied.slotOf(held)].mass, 1);
    EXPECT_EQ(found[tied.slotOf(held)].pull, 0);
}

// A random graph of bodies, some of them fixed, and of joints. The expected loads follow from removing each
// joint and finding the bodies that are then still connected.
struct Graph {
    struct Edge {
        std::size_t a = 0;
        std::size_t b = 0; // bodies.size(): the world
        JointForm form = JointForm::hinge;
        ObjectId id;
    };
    TiedBodies tied;
    std::vector<ObjectId> bodies;
    std::vector<bool> fixed;
    std::vector<double> mass;
    std::vector<Vec2> at;
    std::vector<Vec2> force;
    std::vector<Edge> edges;

    Graph() {
        auto const count = static_cast<std::size_t>(*rc::gen::inRange(1, 9));
        for (std::size_t i = 0; i < count; ++i) {
            at.push_back({1.0 * *rc::gen::inRange(-8, 9), 1.0 * *rc::gen::inRange(-8, 9)});
            fixed.push_back(*rc::gen::inRange(0, 5) == 0);
            mass.push_back(*rc::gen::inRange(1, 20));
            force.push_back({1.0 * *rc::gen::inRange(-9, 10), 1.0 * *rc::gen::inRange(-9, 10)});
            bodies.push_back(fixed[i] ? tied.fixed(at[i]) : tied.body(at[i], mass[i]));
            if (!fixed[i]) {
                tied.pull(bodies[i], force[i]);
            }
        }
        int const joints = *rc::gen::inRange(0, 14);
        for (int i = 0; i < joints; ++i) {
            Edge edge;
            edge.a = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(count)));
            edge.b = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(count) + 1));
            edge.form = *rc::gen::element(JointForm::hinge, JointForm::weld, JointForm::distance,
                                          JointForm::rope, JointForm::slider, JointForm::spring);
            if (edge.a == edge.b || (stands(edge.a) && stands(edge.b))) {
                continue; // such a joint would be refused
            }
            ObjectId const b = edge.b == count ? ObjectId{} : bodies[edge.b];
            edge.id = tied.joint(edge.form, bodies[edge.a], b, at[edge.a]);
            edges.push_back(edge);
        }
        tied.settle();
    }
    [[nodiscard]] bool stands(std::size_t i) const { return i == bodies.size() || fixed[i]; }
    // Every movable body that is connected with `from` without the edge `out`; fixed bodies do not connect
    // others. `held` becomes true if any of them is joined to a fixed body.
    [[nodiscard]] std::set<std::size_t> side(std::size_t from, std::size_t out, bool& held) const {
        std::set<std::size_t> found{from};
        for (bool more = true; more;) {
            more = false;
            for (std::size_t e = 0; e < edges.size(); ++e) {
                if (e == out || edges[e].form == JointForm::spring) {
                    continue;
                }
                for (auto const& [here, there] :
                     {std::pair(edges[e].a, edges[e].b), std::pair(edges[e].b, edges[e].a)}) {
                    if (!stands(here) && found.contains(here)) {
                        held = held || stands(there);
                        more = (!stands(there) && found.insert(there).second) || more;
                    }
                }
            }
        }
        return found;
    }
    [[nodiscard]] JointLoad loadOf(std::set<std::size_t> const& side, bool alone) const {
        JointLoad load;
        load.alone = alone;
        Vec2 moment;
        Vec2 sum;
        double pulls = 0;
        for (std::size_t const i : side) {
            load.mass += mass[i];
            moment += mass[i] * at[i];
            sum += force[i];
            pulls += length(force[i]);
        }
        load.pull = alone ? length(sum) : pulls;
        load.centre = alone ? moment / load.mass : Vec2{};
        return load;
    }
    // The valid loads of a joint: one, or two if both its sides weigh the same.
    [[nodiscard]] std::vector<JointLoad> answers(std::size_t e) const {
        if (edges[e].form == JointForm::spring) {
            return {JointLoad{}};
        }
        bool held = false;
        bool const movesA = !stands(edges[e].a);
        bool const movesB = !stands(edges[e].b);
        std::size_t const here = movesA ? edges[e].a : edges[e].b;
        std::set<std::size_t> const all = side(here, edges.size(), held);
        bool heldA = !movesA;
        bool heldB = !movesB;
        std::set<std::size_t> const sideA = movesA ? side(edges[e].a, e, heldA) : std::set<std::size_t>{};
        std::set<std::size_t> const sideB = movesB ? side(edges[e].b, e, heldB) : std::set<std::size_t>{};
        if ((heldA && heldB) || (movesA && movesB && sideA == sideB)) {
            return {loadOf(all, false)};
        }
        if (heldA || heldB) {
            return {loadOf(heldA ? sideB : sideA, true)};
        }
        JointLoad const a = loadOf(sideA, true);
        JointLoad const b = loadOf(sideB, true);
        return a.mass == b.mass ? std::vector{a, b} : std::vector{a.mass < b.mass ? a : b};
    }
};

bool alike(JointLoad const& x, JointLoad const& y) {
    return x.alone == y.alone && std::abs(x.mass - y.mass) < 1e-9 && std::abs(x.pull - y.pull) < 1e-9 &&
           length(x.centre - y.centre) < 1e-9;
}

TEST(JointGraph, OfAnyGraphAgreesWithRemovingEachJoint) {
    EXPECT_TRUE(rc::check([] {
        Graph const graph;
        std::vector<JointLoad> const found = loadsIn(graph.tied);
        RC_ASSERT(found.size() == graph.edges.size());
        for (std::size_t e = 0; e < graph.edges.size(); ++e) {
            JointLoad const& load = found[graph.tied.slotOf(graph.edges[e].id)];
            std::vector<JointLoad> const expected = graph.answers(e);
            RC_LOG() << "joint " << e << " of " << graph.edges.size() << ": " << load.mass << " kg, "
                     << load.pull << " N, alone " << load.alone << "; expected " << expected.front().mass
                     << " kg, " << expected.front().pull << " N, " << expected.front().alone << '\n';
            RC_ASSERT(std::any_of(expected.begin(), expected.end(),
                                  [&](JointLoad const& one) { return alike(one, load); }));
        }
    }));
}

} // namespace
} // namespace joint_graph_test
} // namespace trembler::test
