// Limits the number of contacts of a moving body, for heaps in which all bodies overlap each other.
#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <vector>

namespace trembler {

/// Box2D's own rules for which bodies may collide, with a limit: n bodies in one place would have n² contacts
/// and exhaust the memory. No contact is created between two movable bodies if each has this many contacts
/// with other movable bodies. Bodies that do not overlap have far fewer. So the total number of contacts is
/// at most this many per body.
///
/// In a crowd Box2D tests nearly all pairs in each step. The result of the test for a body is therefore
/// cached until contacts may have been destroyed; bodies carry small numbers of their own as user data.
class CrowdFilter final : public b2ContactFilter {
public:
    static constexpr int mostContacts = 64;

    bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) override;

private:
    struct Crowd {
        int atMost = 0; // contacts with other movable bodies: the last count plus the contacts made since
        std::uint64_t fullIn = 0; // the turn in which their count was at the limit
    };
    [[nodiscard]] Crowd& crowdOf(b2Body* body);
    [[nodiscard]] bool isCrowded(b2Body* body);

    std::vector<Crowd> crowds_; // by user data
    std::uint64_t turn_ = 1;
    int32 expected_ = 0; // number of contacts if none has been destroyed since the last call
};

} // namespace trembler
