// A step of a level's first lesson: something that is shown to the player until it has been done.
#pragma once

#include "runtime/math/vec2.hpp"

#include <cstdint>
#include <string>

namespace trembler {

/// Plain data. Steps never change what a level does: no simulation reads them.
struct TeachingStep {
    enum class Kind : std::uint8_t {
        place, ///< a part of the toolbox, at a place
        wire,  ///< between two conductors, while building
        run,   ///< let the world run
        grab,  ///< take hold of an object in a run, and drag it to a place
        cut,   ///< a wire, in a run
    };

    Kind kind = Kind::run;
    std::string object; ///< place: the part; wire, cut: one end; grab: the object to take hold of
    std::string other;  ///< wire, cut: the other end
    Vec2 at;            ///< m: place: where the part goes; grab: where it is dragged
    double angle = 0;   ///< rad: place
    bool flipped = false;
    std::string path; ///< in the file, for messages
};

} // namespace trembler
