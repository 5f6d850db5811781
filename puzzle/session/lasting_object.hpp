// Which object is meant, across the runs of a session.
#pragma once

#include "runtime/object/origin.hpp"

#include <cstdint>
#include <string>

namespace trembler {

/// An object's id ends with its run, and another part may bear its name once the player places otherwise.
/// This is what stays: the number of a placed part, or the place in the level's file. Session::lasting()
/// makes it, Session::find() looks for the object in the world as it is now.
struct LastingObject {
    Origin::Kind kind = Origin::Kind::program;
    /// Of a placement: PlacedPart::number. Of an object or a joint: its index in the level. Otherwise 0.
    std::uint64_t number = 0;
    /// Of any other object, a birth say: its name, which follows from its maker's; else empty.
    std::string name;

    friend bool operator==(LastingObject const&, LastingObject const&) = default;
};

} // namespace trembler
