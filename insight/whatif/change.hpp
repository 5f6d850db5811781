// A change between two frames of a run, to see its consequences.
#pragma once

#include "runtime/math/vec2.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace trembler::insight {

/// A value of a field: a number, an index of a choice, 0 or 1, or a vector's components.
struct FieldAmount {
    double x = 0;
    double y = 0; ///< of a vector only

    friend bool operator==(FieldAmount const&, FieldAmount const&) = default;
};

struct Change {
    enum class Kind : std::uint8_t {
        place,       ///< `object` is at `at`, turned by `angle`, with all pieces of its part; its speed stays
        remove,      ///< `object` is gone, with all pieces of its part
        field,       ///< the field `field` of the property `property` of `object` is `amount`
        cut,         ///< the wire between `object` and `other` is cut
        grab,        ///< a hand takes `object` at the point `at` and pulls it to `to` for `frames` frames
        input,       ///< the run's input number `index` does not come; nor do those of its grab
        interaction, ///< the interaction with the title `object` is not applied any more
    };
    Kind kind = Kind::place;
    std::string object{}; ///< by name
    std::string other{};
    Vec2 at{};        ///< m
    double angle = 0; ///< rad
    Vec2 to{};        ///< m
    std::uint64_t frames = 60;
    std::string property{}; ///< its key
    std::string field{};    ///< its key
    FieldAmount amount{};
    std::size_t index = 0; ///< of the session's inputs

    friend bool operator==(Change const&, Change const&) = default;
};

/// A change after a frame of a run, before the next one.
struct WhatIf {
    std::uint64_t frame = 0; ///< 0: before the first
    std::vector<Change> changes{};

    /// Adds a change, in place of an earlier one of the same thing: an object that was moved is moved
    /// further.
    void add(Change change);

    friend bool operator==(WhatIf const&, WhatIf const&) = default;
};

} // namespace trembler::insight
