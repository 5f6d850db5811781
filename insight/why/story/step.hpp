// A step of a story: an event that a person would name.
#pragma once

#include "runtime/trace/event.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace trembler::insight {

enum class StepKind : std::uint8_t {
    goal,      ///< a goal was met
    contact,   ///< two objects began to touch, or touched for less than a frame
    apart,     ///< two objects ceased to touch
    on,        ///< current began to flow through an object
    off,       ///< current ceased to flow through an object
    magnetOn,  ///< a magnet was switched on
    magnetOff, ///< or off
    pull,      ///< a magnet began to pull an object: the object, and the magnet
    liquid,    ///< an object entered a liquid
    grabbed,   ///< the player took hold of an object
    released,  ///< or let go
    cut,       ///< the player cut a wire
    removed,   ///< or removed an object
    placed,    ///< the player laid an object there before the start
    wired,     ///< the player connected two objects before the start
    other,     ///< anything else that a person would name
    push,      ///< a magnet began to push an object away: the object, and the magnet
};

struct Step {
    StepKind kind = StepKind::other;
    EventId event; ///< none for `placed` and `wired`
    std::uint64_t frame = 0;
    std::string component; ///< as the trace has them
    std::string what;
    std::vector<std::string> objects;
    std::vector<std::size_t> because; ///< steps, ascending; each is earlier in the story than this one
    bool traced = true;               ///< false: the trace does not connect it with what was asked about
    /// Led there from a deed that is not traced, and leads itself to nothing in the story, see withDeeds().
    bool bridge = false;
};

/// Whether a step of this kind is the beginning of what a magnet does to an object.
[[nodiscard]] constexpr bool isPull(StepKind kind) {
    return kind == StepKind::pull || kind == StepKind::push;
}

/// The kind of an event; nothing for a call between components, which no story names, and for a connection,
/// in whose place the contact is named.
[[nodiscard]] std::optional<StepKind> kindOf(Event const& event);

/// The step that describes an event, without causes.
[[nodiscard]] Step stepFor(Event const& event);

} // namespace trembler::insight
