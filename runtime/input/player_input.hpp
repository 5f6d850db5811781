// The player's input to a running world. Recorded with its frames, it makes a run repeatable.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/math/vec2.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace trembler {

struct PlayerInput {
    static constexpr CallText text{
        "playerInput", "(action, object, other object, position, hand)",
        "An input of the player: grab, move, release, cut or remove. It comes from outside the world, not "
        "from an interaction. An input at a position that is not finite is ignored, and one of a hand other "
        "than 0 and 1."};
    static constexpr Algebra algebra =
        Algebra::sequence; // a move before a grab has another effect than after it
    enum class Kind : std::uint8_t {
        grab,    ///< takes hold of `object` at the world point `at`
        move,    ///< moves the hold to `at`
        release, ///< lets go
        cut,     ///< cuts the wire between `object` and `other`
        remove,  ///< removes `object` from the world
    };
    Kind kind = Kind::release;
    ObjectId object;
    ObjectId other;
    Vec2 at;               ///< m, in the world
    std::uint8_t hand = 0; ///< grab, move, release: which of the two hands, 0 or 1

    [[nodiscard]] std::array<ObjectId, 2> objects() const { return {object, other}; }
};

/// The names of the kinds, as files spell them, in order.
inline constexpr std::string_view playerInputNames[] = {"grab", "move", "release", "cut", "remove"};

/// The player's input reaches a world through this role alone: it is fed from outside, no interaction calls
/// it.
struct PlayerRole {
    static constexpr std::string_view name = "Player";
    static constexpr std::string_view fedBy = "the player";
    using Calls = CallList<PlayerInput>;
};

} // namespace trembler
