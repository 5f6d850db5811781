// Dynamics in frames of several parts: the same laws, and contacts that exist in one part only are reported.
#include "physics/dynamics/properties/force_lag.hpp"
#include "physics/dynamics/properties/solver_choice.hpp"
#include "runtime/frame/frame_resolver.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

using test::engines;
using test::OnEveryEngine;
using test::Scene;

class PartsTest : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(PartsTest);

void inParts(Scene& scene, int parts) {
    scene.give(scene.world->store().find("world"), FrameSettings{parts});
}

TouchingPair pairOf(ObjectId a, ObjectId b) {
    return {std::min(a, b), std::max(a, b), {}};
}
bool contains(std::vector<TouchingPair> const& pairs, TouchingPair const& pair) {
    return std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
}

TEST_P(PartsTest, AThrownBallFallsByTheParabola) {
    for (int const parts : {1, 2, 4, 8}) {
        Scene scene;
        inParts(scene, parts);
        ObjectId const ball = scene.ball({0, 10});
        scene.give(ball, Velocity{{3, 4}});
        scene.run(60);
        // Weight is passed on at the end of the first part, and acts from the second one on.
        double const first = 1.0 / 60 / parts;
        double const t = 1 - first;
        EXPECT_NEAR(scene.at(ball).x, 3, 1e-3) << parts;
        EXPECT_NEAR(scene.velocity(ball).y, 4 - 9.81 * t, 1e-3) << parts;
        // In steps of h the semi-implicit Euler method falls by g h t / 2 more, Chipmunk's less.
        EXPECT_NEAR(scene.at(ball).y, 10 + 4 - 9.81 * t * t / 2, 9.81 * t / 60 / 4) << parts;
    }
}

TEST_P(PartsTest, ABounceInAnyPartOfAFrameIsReported) {
    for (int const parts : {1, 2, 4, 8}) {
        int withinAFrame = 0;
        for (int start = 0; start < 24; ++start) {
            Scene scene;
            inParts(scene, parts);
            ObjectId const floor = scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
            ObjectId const ball = scene.ball({0, 0.5 + 0.01 * start});
            scene.give(ball, Restitution{1});
            scene.give(ball, Velocity{{0, -8}});
            TouchingPair const pair = pairOf(floor, ball);
            int bounces = 0;
            scene.run(0);
            for (int frame = 0; frame < 12; ++frame) {
                bool insideBegun = false;
                bool insideTouched = false;
                scene.world->step([&](World const& inside) {
                    Contacts const& part = *inside.find<Contacts>();
                    insideBegun = insideBegun || contains(part.begun, pair) || contains(part.brief, pair);
                    insideTouched =
                        insideTouched || contains(part.current, pair) || contains(part.brief, pair);
                });
                Contacts const& whole = scene.contacts();
                bool const brief = contains(whole.brief, pair);
                bool const begun = contains(whole.begun, pair);
                bool const current = contains(whole.current, pair);
                EXPECT_EQ(insideBegun, begun || brief) << "in a frame of " << parts;
                EXPECT_TRUE(!insideTouched || current || brief || contains(whole.ended, pair));
                EXPECT_LE(brief + begun + contains(whole.ended, pair), 1) << "a pair is in one list only";
                EXPECT_TRUE(!begun || current);
                bounces += insideBegun ? 1 : 0;
                withinAFrame += brief ? 1 : 0;
            }
            EXPECT_EQ(bounces, 1) << parts << " parts, start " << start;
        }
        EXPECT_GT(withinAFrame, 0) << "some of the contacts end within a frame of " << parts;
    }
}

TEST_P(PartsTest, SubstepsAreThoseOfAFrame) {
    for (int const parts : {1, 2, 4, 8}) {
        for (int const stated : {DynamicsSettings::automatic, 1, 6, 16}) {
            Scene::Options options;
            options.solver.substeps = stated;
            Scene scene(options);
            inParts(scene, parts);
            scene.ball({0, 0});
            scene.run(2);
            int const wanted = stated == DynamicsSettings::automatic ? 4 : stated;
            int const each = (wanted + parts - 1) / parts; // at least one in each part
            ForceLag const lag = *scene.world->find<ForceLag>();
            EXPECT_DOUBLE_EQ(lag.turn, 1.0 / 60 / parts);
            EXPECT_DOUBLE_EQ(lag.step, on("native") ? 0 : lag.turn / each) << stated << " in " << parts;
            EXPECT_EQ(scene.world->find<SolverChoice>()->substeps, each * parts);
        }
    }
}

/// A weight on a spring: F = -k x, computed once in each part, with its rate.
struct StatedSpring {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"StatedSpring", "test_spring", "A spring to the origin, for tests.",
                                       PropertyPlace::hidden};
    double rate = 0; ///< rad/s
};
class DynamicsFromStatedSpring final
    : public Interaction<DynamicsFromStatedSpring, DynamicsRole,
                         Reads<StatedSpring, Mass, Position, Velocity, ForceLag>> {
public:
    static constexpr ComponentText text{
        .name = "Dynamics <- StatedSpring", .effect = "test", .level = "", .work = "Pulls, and looks ahead."};
    using Activation = NeedsAll<StatedSpring>;
    void apply(Access& access) {
        auto const& springs = access.read<StatedSpring>();
        for (std::size_t row = 0; row < springs.size(); ++row) {
            ObjectId const id = springs.owners()[row];
            double const rate = springs.values()[row].rate;
            Vec2 const then = access.read<Position>()[id].value +
                              access.read<ForceLag>().ofTurn() * access.read<Velocity>()[id].value;
            access.call(AddForce{id, (-rate * rate * access.read<Mass>()[id].value) * then});
            access.call(StateRate{.object = id, .rate = rate, .foreseen = true, .swings = true});
        }
    }
};

struct Swung {
    int parts = 0;          ///< of the last frame
    int substeps = 0;       ///< of each part
    double growth = 0;      ///< relative growth of the energy after two seconds
    double exact = 0;       ///< the same for the recurrence below
    double missed = 0;      ///< deviation from the recurrence, relative to the amplitude
    double determinant = 0; ///< of the recurrence
};

/// One part of a frame, by formula: the force of the last state, extrapolated by `lag`, acts for the whole
/// part, which the engine integrates by the semi-implicit Euler method in m steps of h:
///   v' = v - w^2 m h (x + lag v),  x' = x + m h v - w^2 h^2 m (m + 1) / 2 (x + lag v).
/// With the lag of ForceLag, (m - 1) h / 2, its determinant is 1: it oscillates for ever without gaining
/// energy.
void swingOnPaper(double rate, ForceLag const& lag, int substeps, double& x, double& v) {
    double const acceleration = -rate * rate * (x + lag.ofTurn() * v);
    x += lag.turn * v + lag.step * lag.step * substeps * (substeps + 1) / 2 * acceleration;
    v += lag.turn * acceleration;
}

Swung swing(double rate, std::int32_t parts) {
    Scene::Options options;
    options.extend = [](Registry& registry) { registry.component<DynamicsFromStatedSpring>(); };
    options.solver.sleeping = false;
    Scene scene(options);
    inParts(scene, parts);
    scene.gravity = 0;
    ObjectId const ball = scene.ball({0, 0});
    scene.give(ball, StatedSpring{rate});
    scene.give(ball, Velocity{{1, 0}});
    auto const energyOf = [&](double x, double v) { return (v * v + rate * rate * x * x) / 2; };
    Swung found;
    scene.run(4); // until the force is in effect and the frame is divided
    double x = scene.at(ball).x;
    double v = scene.velocity(ball).x;
    double const before = energyOf(x, v);
    double const width = std::sqrt(2 * before) / rate;
    found.parts = scene.world->find<FrameParts>()->parts;
    ForceLag const lag = *scene.world->find<ForceLag>();
    found.substeps = static_cast<int>(std::lround(lag.turn / lag.step));
    double columns[2][2] = {{1, 0}, {0, 1}};
    for (auto& column : columns) {
        swingOnPaper(rate, lag, found.substeps, column[0], column[1]);
    }
    found.determinant = columns[0][0] * columns[1][1] - columns[0][1] * columns[1][0];
    for (int frame = 0; frame < 120 && found.growth < 1e3; ++frame) {
        scene.run(1);
        for (int part = 0; part < found.parts; ++part) {
            swingOnPaper(rate, lag, found.substeps, x, v);
        }
        found.growth =
            std::max(found.growth, energyOf(scene.at(ball).x, scene.velocity(ball).x) / before - 1);
        found.exact = std::max(found.exact, energyOf(x, v) / before - 1);
        found.missed = std::max(found.missed, std::abs(scene.at(ball).x - x) / width);
        EXPECT_EQ(scene.world->find<FrameParts>()->parts, found.parts);
    }
    return found;
}

TEST(AutomaticParts, IncreaseForForcesThatAreTooFastForAFrame) {
    test::WithEngine const box2d("box2d"); // the motion on paper is that of its method
    EXPECT_EQ(swing(10, FrameSettings::automatic).parts, 1) << "a sixth of a radian in a frame";
    for (auto const& [rate, parts] : {std::pair(60.0, 2), {130.0, 4}, {250.0, 8}}) {
        for (int const stated : {FrameSettings::automatic, parts}) {
            Swung const found = swing(rate, stated);
            EXPECT_EQ(found.parts, parts) << rate;
            EXPECT_LT(found.missed, 1e-4) << rate;
            EXPECT_NEAR(found.growth, found.exact, 1e-4) << rate;
            EXPECT_NEAR(found.determinant, 1, 1e-12) << "with determinant 1 the energy does not grow";
        }
    }
    Swung const whole = swing(130, 1);
    EXPECT_GT(whole.growth, 1e3) << "explicit integration is unstable from two radians in a step on";
    EXPECT_GT(whole.exact, 1e3);
}

TEST(ContactsOfAFrame, AreThoseOfItsParts) {
    ObjectId const a{1, 1};
    ObjectId const b{2, 1};
    ObjectId const c{3, 1};
    ObjectId const d{4, 1};
    auto const pair = [](ObjectId x, ObjectId y, std::uint64_t event) {
        return TouchingPair{x, y, EventId{event}};
    };
    Contacts frame;
    // a-b has touched all along, a-c ends in part 1 and begins again in part 3, a-d begins and ends, b-c
    // begins, b-d ends, c-d is brief in part 2.
    Contacts one;
    one.current = {pair(a, b, 1), pair(a, d, 2), pair(b, d, 3)};
    one.begun = {pair(a, d, 2)};
    one.ended = {pair(a, c, 4)};
    Contacts two;
    two.current = {pair(a, b, 1), pair(b, c, 5)};
    two.begun = {pair(b, c, 5)};
    two.ended = {pair(a, d, 6), pair(b, d, 7)};
    two.brief = {pair(c, d, 8)};
    Contacts three;
    three.current = {pair(a, b, 1), pair(a, c, 9), pair(b, c, 5)};
    three.begun = {pair(a, c, 9)};
    Contacts::gather(frame, one, {.first = true, .begin = 0, .share = 0.25});
    Contacts::gather(frame, two, {.first = false, .begin = 1, .share = 0.25});
    Contacts::gather(frame, three, {.first = false, .begin = 2, .share = 0.25});
    EXPECT_EQ(frame.current, three.current);
    EXPECT_EQ(frame.begun, (std::vector{pair(b, c, 5)}));
    EXPECT_EQ(frame.ended, (std::vector{pair(b, d, 7)}));
    ASSERT_EQ(frame.brief, (std::vector{pair(a, d, 2), pair(c, d, 8)}));
    EXPECT_EQ(frame.ended[0].event, EventId{7});
    EXPECT_EQ(frame.brief[0].event, EventId{2});
    EXPECT_EQ(frame.brief[1].event, EventId{8});
}

} // namespace
} // namespace trembler
