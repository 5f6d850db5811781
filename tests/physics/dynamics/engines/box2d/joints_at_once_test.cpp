// The joints of a Box2D world solved all at once: afterwards joined points do not move apart, and in a
// hanging chain each joint carries the load below it.
#include "physics/dynamics/engines/box2d/joints_at_once.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler {
namespace joints_at_once_test {
namespace {

constexpr float h = 1.0F / 240;

/// Discs in a world without gravity of its own, and joints between them.
class Chain {
public:
    Chain() : world_(b2Vec2_zero) {
        b2BodyDef def;
        ground = world_.CreateBody(&def);
        ground->GetUserData().pointer = 0;
    }
    b2Body* disc(b2Vec2 at, float density = 1) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position = at;
        def.userData.pointer = ++count_;
        b2Body* const body = world_.CreateBody(&def);
        b2CircleShape circle;
        circle.m_radius = 0.2F;
        body->CreateFixture(&circle, density);
        discs.push_back(body);
        return body;
    }
    void hinge(b2Body* a, b2Body* b, b2Vec2 at) {
        b2RevoluteJointDef def;
        def.Initialize(a, b, at);
        joints.push_back(world_.CreateJoint(&def));
    }
    void weld(b2Body* a, b2Body* b, b2Vec2 at) {
        b2WeldJointDef def;
        def.Initialize(a, b, at);
        joints.push_back(world_.CreateJoint(&def));
    }
    void distance(b2Body* a, b2Body* b) {
        b2DistanceJointDef def;
        def.Initialize(a, b, a->GetPosition(), b->GetPosition());
        def.minLength = def.maxLength = def.length;
        joints.push_back(world_.CreateJoint(&def));
    }
    void solve(b2Vec2 acceleration) {
        solver.setJoints(joints);
        again(acceleration);
    }
    void again(b2Vec2 acceleration) {
        solver.solve(h, [&](b2Body const& body) {
            return JointsAtOnce::Pull{body.GetMass() * acceleration, 0};
        });
    }
    /// The velocity that a point of a body will have after the pull has acted.
    [[nodiscard]] static b2Vec2 velocityAt(b2Body const& body, b2Vec2 point, b2Vec2 acceleration) {
        b2Vec2 const own = body.GetLinearVelocityFromWorldPoint(point);
        return body.GetType() == b2_dynamicBody ? own + h * acceleration : own;
    }

private:
    b2World world_;
    std::uintptr_t count_ = 0;

public:
    b2Body* ground = nullptr;
    std::vector<b2Body*> discs;
    std::vector<b2Joint*> joints;
    JointsAtOnce solver;
};

float anyBetween(float low, float high) {
    return low + (high - low) * *rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 100'001)),
                                              [](int i) { return static_cast<float>(i) / 1e5F; });
}

TEST(JointsAtOnce, JoinedPointsDoNotMoveApart) {
    EXPECT_TRUE(rc::check("every joint's ends move alike", [] {
        Chain chain;
        b2Vec2 const acceleration{anyBetween(-5, 5), anyBetween(-20, 5)};
        b2Vec2 at{0, 0};
        b2Body* before = chain.ground;
        for (int i = *rc::gen::inRange(1, 20); i > 0; --i) {
            b2Vec2 const next = at + b2Vec2{anyBetween(0.3F, 1), anyBetween(-1, 0.3F)};
            b2Body* const body = chain.disc(next, anyBetween(0.2F, 5));
            body->SetLinearVelocity({anyBetween(-2, 2), anyBetween(-2, 2)});
            body->SetAngularVelocity(anyBetween(-3, 3));
            switch (*rc::gen::inRange(0, 3)) {
            case 0:
                chain.hinge(before, body, 0.5F * (at + next));
                break;
            case 1:
                chain.weld(before, body, 0.5F * (at + next));
                break;
            default:
                chain.distance(before, body);
            }
            before = *rc::gen::inRange(0, 5) == 0 ? chain.ground : body; // trees, not only chains
            at = before->GetPosition();
        }
        chain.solve(acceleration);
        for (b2Joint* const joint : chain.joints) {
            b2Body const& a = *joint->GetBodyA();
            b2Body const& b = *joint->GetBodyB();
            b2Vec2 apart = Chain::velocityAt(b, joint->GetAnchorB(), acceleration) -
                           Chain::velocityAt(a, joint->GetAnchorA(), acceleration);
            if (joint->GetType() == e_distanceJoint) {
                b2Vec2 along = joint->GetAnchorB() - joint->GetAnchorA();
                along.Normalize();
                apart = b2Dot(apart, along) * along;
            }
            RC_ASSERT(apart.Length() < 2e-4F);
            if (joint->GetType() == e_weldJoint) {
                RC_ASSERT(std::abs(b.GetAngularVelocity() - a.GetAngularVelocity()) < 1e-3F);
            }
        }
    }));
}

TEST(JointsAtOnce, InAHangingChainEachJointCarriesTheLoadBelowIt) {
    Chain chain;
    b2Vec2 const acceleration{0, -10};
    b2Body* before = chain.ground;
    for (int i = 0; i < 40; ++i) {
        b2Body* const body = chain.disc({0, -1.0F * static_cast<float>(i) - 1}, i == 39 ? 500.0F : 1.0F);
        chain.hinge(before, body, {0, -1.0F * static_cast<float>(i) - 0.5F});
        before = body;
    }
    chain.solve(acceleration);
    float below = 0;
    for (std::size_t i = chain.discs.size(); i-- > 0;) {
        below += chain.discs[i]->GetMass();
        b2Vec2 const impulse = chain.solver.impulse(static_cast<SlotIndex>(i));
        EXPECT_NEAR(impulse.y / (h * 10 * below), 1, 1e-5) << i;
        EXPECT_NEAR(impulse.x, 0, 1e-5);
        EXPECT_NEAR(chain.discs[i]->GetLinearVelocity().y, h * 10, 1e-5)
            << "the velocity that the pull will remove";
    }
    EXPECT_EQ(chain.solver.impulse(1000).y, 0) << "there is no such joint";
    // Two hinges in one place share the load.
    chain.hinge(chain.ground, chain.discs[0], {0, -0.5F});
    for (b2Body* const body : chain.discs) {
        body->SetLinearVelocity(b2Vec2_zero);
    }
    chain.solve(acceleration);
    auto const last = static_cast<SlotIndex>(chain.joints.size() - 1);
    EXPECT_NEAR(chain.solver.impulse(0).y / chain.solver.impulse(last).y, 1, 1e-2);
    EXPECT_NEAR((chain.solver.impulse(0).y + chain.solver.impulse(last).y) / (h * 10 * below), 1, 1e-3);
}

TEST(JointsAtOnce, GivesAPairInTheAirNoMomentum) {
    EXPECT_TRUE(rc::check("momentum and angular momentum stay", [] {
        Chain chain;
        b2Body* const a = chain.disc({0, 0}, anyBetween(0.2F, 5));
        b2Body* const b = chain.disc({1, anyBetween(-1, 1)}, anyBetween(0.2F, 5));
        for (b2Body* const body : chain.discs) {
            body->SetLinearVelocity({anyBetween(-2, 2), anyBetween(-2, 2)});
            body->SetAngularVelocity(anyBetween(-3, 3));
        }
        if (*rc::gen::arbitrary<bool>()) {
            chain.hinge(a, b, {anyBetween(0, 1), anyBetween(-1, 1)});
        } else {
            chain.weld(a, b, {anyBetween(0, 1), anyBetween(-1, 1)});
        }
        auto const momentum = [&] {
            b2Vec2 linear{0, 0};
            float angular = 0;
            for (b2Body* const body : chain.discs) {
                b2Vec2 const p = body->GetMass() * body->GetLinearVelocity();
                linear += p;
                angular +=
                    b2Cross(body->GetWorldCenter(), p) + body->GetInertia() * body->GetAngularVelocity();
            }
            return b2Vec3(linear.x, linear.y, angular);
        };
        b2Vec3 const before = momentum();
        chain.solve({0, 0});
        b2Vec3 const after = momentum();
        RC_ASSERT(std::abs(after.x - before.x) < 1e-5F);
        RC_ASSERT(std::abs(after.y - before.y) < 1e-5F);
        RC_ASSERT(std::abs(after.z - before.z) < 1e-5F);
    }));
}

TEST(JointsAtOnce, LeavesDenseNetworksAndMissingJointsUnchanged) {
    Chain net; // every disc joined to every other
    for (int i = 0; i < 60; ++i) {
        net.disc({static_cast<float>(i % 8), static_cast<float>(i / 8)});
    }
    for (std::size_t i = 0; i < net.discs.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            net.distance(net.discs[i], net.discs[j]);
        }
    }
    net.solve({0, -10});
    for (b2Body* const body : net.discs) {
        EXPECT_EQ(body->GetLinearVelocity().Length(), 0);
    }
    EXPECT_EQ(net.solver.impulse(5).Length(), 0);
    Chain none;
    none.disc({0, 0});
    none.joints = {nullptr, nullptr};
    none.solve({0, -10});
    EXPECT_EQ(none.discs[0]->GetLinearVelocity().y, 0);
    EXPECT_EQ(none.solver.impulse(1).Length(), 0);
}

// The symbolic factorisation is kept from step to step; the numbers follow the bodies.
TEST(JointsAtOnce, FollowsTheBodiesFromStepToStep) {
    Chain chain;
    b2Body* const bob = chain.disc({1, 0});
    chain.hinge(chain.ground, bob, {0, 0});
    chain.solve({0, -10});
    // A pendulum released from the side falls freely at first, except for its inertia: tangentially by g m
    // l²/(m l² + I).
    double const massive = bob->GetMass();
    double const share = massive / (massive + bob->GetInertia());
    EXPECT_NEAR(bob->GetLinearVelocity().y + h * -10, -h * 10 * share, 1e-5);
    bob->SetLinearVelocity(b2Vec2_zero);
    bob->SetAngularVelocity(0);
    bob->SetTransform({0, -1}, -b2_pi / 2);
    chain.again({0, -10});
    EXPECT_NEAR(bob->GetLinearVelocity().y, h * 10, 1e-5) << "now it hangs at rest";
}

} // namespace
} // namespace joints_at_once_test
} // namespace trembler
