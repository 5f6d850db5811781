// Where an object comes from: what it is made from and by whom.
#pragma once

#include "runtime/object/object_id.hpp"

#include <optional>

namespace trembler {

/// What the store knows of an object from the moment it is created, so that nobody has to conclude it from
/// the object's name or place.
///
/// It is not a property: a component or a completion can read only what it declares, and an origin cannot be
/// declared, so no simulation depends on it. A lamp shines because of its properties, not because it was made
/// from a part called "lamp". For the same reason it is not part of the state hash (World::stateHash()): what
/// comes next does not follow from it. Who looks at a world from outside (goals, the session, the window)
/// reads it with Store::originOf(). Rules and connectors, which are handed the store before the first frame,
/// must not: scripts/checks.d/origins.sh.
struct Origin {
    enum class Kind : std::uint8_t {
        program,   ///< Store::create() was called with no origin: from no level, as in tests
        world,     ///< the one object "world" that every level has
        object,    ///< an entry of the level's "objects"
        joint,     ///< an entry of the level's "joints"
        placement, ///< placed by the player or by a recorded solution
        birth,     ///< created by a call (CreateObject) while the world ran
    };
    Kind kind = Kind::program;
    /// The number, in the store's PrototypeLibrary, of the part that it is made from; none: its entry states
    /// all properties itself.
    std::optional<std::uint32_t> prototype;
    /// Of an object, a joint or a placement: its index in the list that the world was built from, from 0. Of
    /// a birth: the number that its maker gave it. Otherwise 0.
    std::uint64_t number = 0;
    /// Of a birth: the object that asked for it, which may no longer exist. Otherwise invalid.
    ObjectId maker;

    friend bool operator==(Origin const&, Origin const&) = default;
};

} // namespace trembler
