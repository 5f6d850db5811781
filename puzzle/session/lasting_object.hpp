// Identifies an object across the runs of a session.
#pragma once

#include "runtime/object/origin.hpp"

#include <cstdint>
#include <string>

namespace trembler {

/// An object's id is valid for one run only, and after an edit another part may have its name. This
/// identifies the object across runs: by the number of a placed part, or by its place in the level's file.
/// Session::lasting() makes it, Session::find() finds the object in the present world.
struct LastingObject {
    Origin::Kind kind = Origin::Kind::program;
    /// Of a placement: PlacedPart::number. Of an object or a joint: its index in the level. Otherwise 0.
    std::uint64_t number = 0;
    /// Of any other object, for example one created during the run: its name, which follows from its maker's
    /// name. Otherwise empty.
    std::string name;
    /// Of an object that is made from a composite part: Origin::piece.
    std::uint32_t piece = 0;

    friend bool operator==(LastingObject const&, LastingObject const&) = default;
};

} // namespace trembler
