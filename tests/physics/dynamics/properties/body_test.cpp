// Collision groups compared with Box2D's own filter.
#include "physics/dynamics/properties/body.hpp"

#include <box2d/box2d.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace trembler {
namespace {

b2Filter filterOf(CollisionGroups const& groups) {
    b2Filter filter;
    filter.categoryBits = static_cast<uint16>(groups.category);
    filter.maskBits = static_cast<uint16>(groups.mask);
    filter.groupIndex = static_cast<int16>(groups.group);
    return filter;
}

TEST(CollisionGroups, DecideAsBox2dDoes) {
    b2World world(b2Vec2_zero);
    b2BodyDef const def;
    b2CircleShape circle;
    circle.m_radius = 1;
    b2Fixture* const a = world.CreateBody(&def)->CreateFixture(&circle, 1);
    b2Fixture* const b = world.CreateBody(&def)->CreateFixture(&circle, 1);
    EXPECT_TRUE(rc::check("canHit", [&] {
        auto const groups = [] {
            auto const bits = [] { return *rc::gen::element(0, 1, 2, 3, 6, 0x8000, 0xffff); };
            return CollisionGroups{bits(), bits(), *rc::gen::inRange(-2, 3)};
        };
        CollisionGroups const x = groups();
        CollisionGroups const y = groups();
        a->SetFilterData(filterOf(x));
        b->SetFilterData(filterOf(y));
        RC_ASSERT(canHit(x, y) == b2ContactFilter().ShouldCollide(a, b));
    }));
    EXPECT_TRUE(canHit({}, {}));
}

} // namespace
} // namespace trembler
