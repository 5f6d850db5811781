// The recorded causes of motion.
#include "physics/dynamics/properties/motion_causes.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

#include <set>

namespace trembler::test {
namespace {

class Causes : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Causes);

struct ReadsCauses final : Interaction<ReadsCauses, DynamicsRole, Reads<MotionCauses>> {
    static constexpr ComponentText text{
        .name = "Dynamics <- Causes", .effect = "test", .level = "", .work = "Looks."};
    using Activation = NeedsAll<>;
    void apply(Access&) {}
};

// The causes of the first event of that name that concerns both objects, as "event of object".
std::set<std::string> chainOf(Scene const& scene, std::string const& what,
                              std::set<std::string> const& objects) {
    Tracer const& tracer = *scene.world->tracer();
    std::set<std::string> chain;
    for (Event const& event : tracer.events()) {
        bool const wanted =
            event.event == what || (event.event == "contact brief" && what == "contact begun");
        if (wanted && std::set<std::string>(event.objects.begin(), event.objects.end()) == objects) {
            for (EventId const id : tracer.chain(event.id)) {
                Event const& cause = *tracer.find(id);
                std::string const name = cause.event.starts_with("contact") && !cause.event.ends_with("ended")
                                             ? "contact" // "contact begun" or "contact brief"
                                             : cause.event;
                chain.insert(name + " of " + cause.objects[0]);
            }
            break;
        }
    }
    return chain;
}

TEST_P(Causes, LeadThroughARowOfImpactsToTheFirstPush) {
    Scene scene({.trace = true});
    scene.gravity = 0;
    ObjectId const first = scene.body("first", circlePiece(0.1), {0, 0});
    for (char const* name : {"second", "third", "fourth"}) {
        double const x = name[0] == 's' ? 0.5 : name[0] == 't' ? 1 : 1.5;
        ObjectId const id = scene.body(name, circlePiece(0.1), {x, 0});
        scene.give(id, Restitution{1});
    }
    scene.give(first, Kick{{10, 0}, {0, 0}, 1});
    scene.run(120);
    std::set<std::string> const chain = chainOf(scene, "contact begun", {"third", "fourth"});
    EXPECT_TRUE(chain.contains("addImpulse of first"));
    EXPECT_TRUE(chain.contains("contact of first"));
    EXPECT_TRUE(chain.contains("contact of second"));
    EXPECT_EQ(chainOf(scene, "contact begun", {"first", "second"}).size(), 2U);
}

TEST_P(Causes, PassThroughJointsAndThroughRestingContacts) {
    Scene scene({.trace = true});
    scene.fixed("floor", boxPiece(20, 1), {0, -0.5});
    scene.fixed("wall", boxPiece(0.5, 3), {3.5, 1.5});
    ObjectId const sledge = scene.body("sledge", boxPiece(1, 0.2), {0, 0.11});
    ObjectId const load = scene.body("load", boxPiece(0.4, 0.4), {0, 0.42});
    ObjectId const trailer = scene.body("trailer", boxPiece(0.2, 0.2), {-1, 0.11});
    scene.give(load, Friction{2});
    Joint joint;
    joint.form = JointForm::distance;
    joint.a = trailer;
    joint.b = sledge;
    joint.at = {-0.9, 0.11};
    joint.atB = {-0.5, 0.11};
    scene.joint("bar", joint);
    scene.run(60);
    ObjectId const target = scene.body("target", circlePiece(0.2), {-3, 0.2});
    scene.world->store().complete(target);
    scene.run(30);
    scene.give(sledge, Kick{{-400, 0}, scene.at(sledge), 1});
    scene.run(120);
    EXPECT_TRUE(chainOf(scene, "contact begun", {"trailer", "target"}).contains("addImpulse of sledge"));
    EXPECT_FALSE(chainOf(scene, "contact begun", {"floor", "sledge"}).contains("addImpulse of sledge"));
}

TEST_P(Causes, OfEveryBodyCanBeReadAndAreFew) {
    Scene scene({.trace = true, .extend = [](Registry& r) { r.component<ReadsCauses>(); }});
    scene.fixed("floor", boxPiece(20, 1), {0, -0.5});
    std::vector<ObjectId> balls;
    for (int i = 0; i < 30; ++i) {
        balls.push_back(scene.ball({0.05 * (i % 7), 0.3 + 0.22 * i}));
    }
    scene.run(300);
    auto const& causes = *scene.world->find<MotionCauses>();
    EXPECT_EQ(causes.entries.size(), balls.size());
    for (ObjectId const ball : balls) {
        std::vector<EventId> const of = causes.of(ball);
        EXPECT_FALSE(of.empty());
        EXPECT_LE(of.size(), 16U);
        EXPECT_TRUE(std::is_sorted(of.begin(), of.end()));
        for (EventId const id : of) {
            EXPECT_NE(scene.world->tracer()->find(id), nullptr);
        }
    }
    EXPECT_TRUE(causes.of(ObjectId{}).empty());
    scene.world->store().destroy({balls.back()});
    scene.run(1);
    EXPECT_EQ(causes.entries.size(), balls.size() - 1);
    EXPECT_TRUE(causes.of(balls.back()).empty());
}

TEST_P(Causes, IncludeThoseOfEndsOfContacts) {
    Scene scene({.trace = true});
    scene.gravity = 0;
    ObjectId const a = scene.body("a", circlePiece(0.1), {0, 0});
    scene.body("b", circlePiece(0.1), {0.5, 0});
    scene.give(a, Velocity{{2, 0}});
    scene.run(30);
    scene.give(a, Kick{{-20, 0}, scene.at(a), 1});
    scene.run(30);
    std::set<std::string> const chain = chainOf(scene, "contact ended", {"a", "b"});
    EXPECT_TRUE(chain.contains("contact of a"));
    if (!on("ode")) { // ODE itself separates bodies that have overlapped
        EXPECT_TRUE(chain.contains("addImpulse of a"));
    }
}

} // namespace
} // namespace trembler::test
