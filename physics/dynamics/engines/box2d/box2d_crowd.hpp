// How many others a body that moves can touch at most, where all of them are in one heap inside of each
// other.
#pragma once

#include <box2d/box2d.h>

namespace trembler {

/// Box2D's own rules for who may touch whom; but n bodies in one place would make n² contacts, which no
/// memory holds: between two that move and have this many contacts with others that move, each, none is made.
/// Bodies that do not lie inside of each other have far fewer. Hence at most this many contacts for each
/// body, all in all.
class CrowdFilter final : public b2ContactFilter {
public:
    static constexpr int mostContacts = 64;

    bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) override;
};

} // namespace trembler
