// How many others a body that moves can touch at most, where all of them are in one heap inside of each
// other.
#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <vector>

namespace trembler {

/// Box2D's own rules for which bodies may touch; but n bodies in one place would make n² contacts, for which
/// no memory is enough: between two that move and have this many contacts with others that move, each, none
/// is made. Bodies that do not lie inside of each other have far fewer. Hence at most this many contacts for
/// each body, all in all.
///
/// In a crowd Box2D asks about nearly all pairs in each step. Which bodies are crowded is therefore kept
/// until contacts may have gone; bodies carry small numbers of their own as user data.
class CrowdFilter final : public b2ContactFilter {
public:
    static constexpr int mostContacts = 64;

    bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) override;

private:
    struct Crowd {
        int atMost = 0;           // contacts with others that move: as last counted, and what was made since
        std::uint64_t fullIn = 0; // the turn in which they were counted as the most that may be
    };
    [[nodiscard]] Crowd& crowdOf(b2Body* body);
    [[nodiscard]] bool isCrowded(b2Body* body);

    std::vector<Crowd> crowds_; // by user data
    std::uint64_t turn_ = 1;
    int32 expected_ = 0; // contacts, if none has gone since the last question
};

} // namespace trembler
