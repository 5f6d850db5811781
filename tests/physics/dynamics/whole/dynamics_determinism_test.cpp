// The same bits for any order of calls and of creation.
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>

namespace trembler::test {
namespace {

class DynamicsDeterminism : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(DynamicsDeterminism);

// A pile with joints and compounds, whose shapes are given in the order of `order`.
std::vector<std::uint64_t> hashes(std::vector<int> const& order, int threads = 1) {
    Scene scene({.threads = threads});
    std::vector<ObjectId> ids;
    for (std::size_t i = 0; i < order.size(); ++i) {
        ids.push_back(scene.world->store().create("body " + std::to_string(i)));
    }
    ObjectId const floor = scene.world->store().create("floor");
    ObjectId const pin = scene.world->store().create("pin");
    ObjectId const rope = scene.world->store().create("rope");
    for (int const n : order) {
        ObjectId const id = ids[static_cast<std::size_t>(n)];
        Shape shape{{n % 3 == 0 ? circlePiece(0.2) : boxPiece(0.3 + 0.01 * n, 0.3)}};
        if (n % 5 == 0) {
            shape.pieces.push_back(capsulePiece(0.6, 0.05, {0.2, 0}, 0.4));
        }
        scene.give(id, shape);
        scene.give(id, Position{{0.37 * (n % 4), 0.5 + 0.45 * n}});
        Pull pull;
        pull.acceleration = {0.1 * n, -9.81};
        scene.give(id, pull);
    }
    scene.give(floor, Shape{{boxPiece(12, 1)}});
    scene.give(floor, Position{{0, -0.5}});
    scene.give(floor, Fixed{});
    Joint joint;
    joint.a = ids[0];
    joint.b = ids[1];
    joint.at = {0.2, 0.7};
    scene.give(pin, joint);
    joint.form = JointForm::rope;
    joint.a = ids[2];
    joint.b = {};
    joint.at = {0.74, 1.4};
    joint.atB = {0.74, 3};
    scene.give(rope, joint);
    std::vector<std::uint64_t> made;
    for (int second = 0; second < 5; ++second) {
        scene.run(60);
        made.push_back(scene.world->stateHash());
    }
    return made;
}

TEST_P(DynamicsDeterminism, SameBitsInEveryRunAndForEveryOrderOfFilling) {
    std::vector<int> order(16);
    std::iota(order.begin(), order.end(), 0);
    std::vector<std::uint64_t> const expected = hashes(order);
    EXPECT_EQ(hashes(order), expected);
    EXPECT_EQ(hashes(order, 3), expected);
    std::reverse(order.begin(), order.end());
    EXPECT_EQ(hashes(order), expected);
    std::rotate(order.begin(), order.begin() + 5, order.end());
    EXPECT_EQ(hashes(order), expected);
}

// Two interactions that pull with forces which are sums of few powers of two: their sums are exact, so
// whichever is registered first, the bits are the same.
template <int N>
struct Push final : Interaction<Push<N>, DynamicsRole, Reads<Mass>> {
    using Base = Interaction<Push<N>, DynamicsRole, Reads<Mass>>;
    static constexpr ComponentText text{.name = N == 0   ? "Dynamics <- Push 0"
                                                : N == 1 ? "Dynamics <- Push 1"
                                                         : "Dynamics <- Push 2",
                                        .effect = "test",
                                        .level = "",
                                        .work = "Pushes."};
    using Activation = NeedsAll<Mass>;
    void apply(typename Base::Access& access) {
        auto const& masses = access.template read<Mass>();
        for (ObjectId const id : masses.owners()) {
            double const f = 0.5 + 0.25 * N + 0.125 * (id.index % 4);
            access.call(AddForce{id, {f, -f * (N + 1)}});
            access.call(AddTorque{id, 0.0625 * (N - 1)});
        }
    }
};

std::uint64_t pushed(void (*extend)(Registry&)) {
    Scene scene({.extend = extend});
    scene.gravity = 0;
    scene.fixed("floor", boxPiece(12, 1), {0, -0.5});
    for (int i = 0; i < 12; ++i) {
        scene.body("body " + std::to_string(i), boxPiece(0.3, 0.2), {0.1 * i, 0.5 + 0.3 * i});
    }
    scene.run(240);
    return scene.world->stateHash();
}

TEST_P(DynamicsDeterminism, TheOrderOfForcesDoesNotMatter) {
    std::uint64_t const expected = pushed([](Registry& r) {
        r.component<Push<0>>();
        r.component<Push<1>>();
        r.component<Push<2>>();
    });
    EXPECT_EQ(expected, pushed([](Registry& r) {
                  r.component<Push<2>>();
                  r.component<Push<0>>();
                  r.component<Push<1>>();
              }));
    EXPECT_EQ(expected, pushed([](Registry& r) {
                  r.component<Push<1>>();
                  r.component<Push<2>>();
                  r.component<Push<0>>();
              }));
}

TEST_P(DynamicsDeterminism, TracingChangesNothing) {
    std::uint64_t hash[2];
    for (bool const trace : {false, true}) {
        Scene scene({.trace = trace});
        scene.fixed("floor", boxPiece(12, 1), {0, -0.5});
        for (int i = 0; i < 12; ++i) {
            scene.body("body " + std::to_string(i), boxPiece(0.3, 0.2), {0.1 * i, 0.5 + 0.3 * i});
        }
        scene.run(240);
        hash[trace ? 1 : 0] = scene.world->stateHash();
    }
    EXPECT_EQ(hash[0], hash[1]);
}

} // namespace
} // namespace trembler::test
