// The origin of an object: the entry, part or object that it was made from or by.
#pragma once

#include "runtime/object/object_id.hpp"

#include <optional>

namespace trembler {

/// Recorded by the store when an object is created, so that no code has to derive it from the object's name
/// or place.
///
/// It is not a property: a component or a completion can read only what it declares, and an origin cannot be
/// declared, so no simulation depends on it. A lamp shines because of its properties, not because it was made
/// from a part called "lamp". For the same reason it is not part of the state hash (World::stateHash()):
/// later frames do not depend on it. Code outside the world (goals, the session, the window) reads it with
/// Store::originOf(). Rules and connectors, which receive the store before the first frame, must not:
/// scripts/checks.d/origins.sh.
struct Origin {
    enum class Kind : std::uint8_t {
        program,   ///< created without an origin: not from a level, as in tests
        world,     ///< the one object "world" that every level has
        object,    ///< an entry of the level's "objects"
        joint,     ///< an entry of the level's "joints"
        placement, ///< placed by the player or by a recorded solution
        birth,     ///< created by a call (CreateObject) while the world ran
    };
    Kind kind = Kind::program;
    /// The number, in the store's PrototypeLibrary, of the part that its entry or its placement names; none:
    /// its entry states all properties, or it is a piece, but not the main one, of a composite part.
    std::optional<std::uint32_t> prototype;
    /// Of an object, a joint or a placement: its index in the list that the world was built from, from 0. Of
    /// a birth: CreateObject::number. Otherwise 0.
    std::uint64_t number = 0;
    /// Of a birth: CreateObject::maker, which may no longer exist. Otherwise invalid.
    ObjectId maker;
    /// Of an object or a placement that is made from a composite part: the object's number among the objects
    /// made from it, from 0: its pieces by name, then its joints by name. Otherwise 0.
    std::uint32_t piece = 0;

    friend bool operator==(Origin const&, Origin const&) = default;
};

} // namespace trembler
