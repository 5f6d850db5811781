#include "physics/dynamics/engines/box2d/box2d_crowd.hpp"

#include <gtest/gtest.h>

#include <random>

namespace trembler {
namespace {

bool isCrowded(b2Body* body) {
    int others = 0;
    for (b2ContactEdge* edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        others += edge->other->GetType() == b2_dynamicBody ? 1 : 0;
    }
    return others >= CrowdFilter::mostContacts;
}

/// Compares each answer with one that counts the contacts.
class Compared final : public b2ContactFilter {
public:
    bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) override {
        b2Body* const a = fixtureA->GetBody();
        b2Body* const b = fixtureB->GetBody();
        bool const movers = a->GetType() == b2_dynamicBody && b->GetType() == b2_dynamicBody;
        bool const expected =
            b2ContactFilter::ShouldCollide(fixtureA, fixtureB) && (!movers || !isCrowded(a) || !isCrowded(b));
        ++asked;
        refused += expected ? 0 : 1;
        bool const answer = filter_.ShouldCollide(fixtureA, fixtureB);
        wrong += answer == expected ? 0 : 1;
        return answer;
    }
    int asked = 0;
    int refused = 0;
    int wrong = 0;

private:
    CrowdFilter filter_;
};

TEST(CrowdFilter, AgreesWithCountingTheContacts) {
    Compared filter;
    b2World world({0, -10});
    world.SetContactFilter(&filter);
    std::mt19937 random(7);
    auto const within = [&](float reach) {
        return reach * (static_cast<float>(random() % 2001) / 1000.0F - 1.0F);
    };
    b2PolygonShape shape;
    shape.SetAsBox(0.5F, 0.5F);
    std::vector<b2Body*> bodies;
    auto const add = [&](std::uintptr_t number, float reach) {
        b2BodyDef def;
        def.type = number % 40 == 0 ? b2_staticBody : b2_dynamicBody;
        def.position = {within(reach), within(reach)};
        def.userData.pointer = number;
        b2Body* const body = world.CreateBody(&def);
        body->CreateFixture(&shape, 1);
        return body;
    };
    for (std::uintptr_t number = 0; number < 250; ++number) {
        bodies.push_back(add(number, 0.3F));
    }
    for (int step = 0; step < 12; ++step) { // bodies scatter, are removed, are added and gather again
        world.Step(1.0F / 60, 4, 2);
        std::size_t const which = random() % bodies.size();
        switch (random() % 4) {
        case 0:
            world.DestroyBody(bodies[which]);
            bodies[which] = add(which, 0.3F);
            break;
        case 1:
            bodies[which]->GetFixtureList()->Refilter();
            break;
        case 2:
            bodies[which]->SetTransform({within(3), within(3)}, 0);
            break;
        default:
            for (b2Body* const body : bodies) {
                body->SetTransform(0.5F * body->GetPosition(), body->GetAngle());
            }
        }
    }
    EXPECT_EQ(filter.wrong, 0);
    EXPECT_GT(filter.asked, 10000);
    EXPECT_GT(filter.refused, 1000);
}

} // namespace
} // namespace trembler
