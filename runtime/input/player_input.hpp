// What a player can do to a running world. Recorded by frame, it makes a run repeatable.
#pragma once

#include "runtime/math/vec2.hpp"
#include "runtime/object/object_id.hpp"

#include <cstdint>
#include <string_view>

namespace trembler {

struct PlayerInput {
    enum class Kind : std::uint8_t {
        grab,    ///< takes hold of `object` at the world point `at`
        move,    ///< moves the hold to `at`
        release, ///< lets go
        cut,     ///< cuts the wire between `object` and `other`
        remove,  ///< takes `object` out of the world
    };
    Kind kind = Kind::release;
    ObjectId object;
    ObjectId other;
    Vec2 at; ///< m, in the world
};

/// The names of the kinds, as files spell them, in order.
inline constexpr std::string_view playerInputNames[] = {"grab", "move", "release", "cut", "remove"};

} // namespace trembler
