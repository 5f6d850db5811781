// One line of the trace of a run: an event and its causes.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

namespace trembler {

/// Identifies an event before the frame's events are gathered: part of a frame, component, chunk and sequence
/// number in one number that does not depend on threads. In the order in which events are listed. 0 is "no
/// event".
struct EventId {
    std::uint64_t value = 0;

    [[nodiscard]] explicit constexpr operator bool() const { return value != 0; }
    friend constexpr auto operator<=>(EventId, EventId) = default;
};

/// When something happens: in which part of which frame.
struct Moment {
    std::uint64_t frame = 0; ///< counted from 1
    std::uint32_t part = 1;  ///< of the frame, counted from 1 ...
    std::uint32_t parts = 1; ///< ... of so many
    std::uint64_t step = 0;  ///< counts the parts of all frames, so that moments sort by it

    Moment() = default;
    /// In a frame of one part, after others of one part.
    constexpr Moment(std::uint64_t whole) : frame(whole), step(whole) {} // NOLINT(*-explicit-*)
    constexpr Moment(std::uint64_t frame_, std::uint32_t part_, std::uint32_t parts_, std::uint64_t step_)
        : frame(frame_), part(part_), parts(parts_), step(step_) {}
};

/// The phase of a frame in which an event occurs; `goal` is for events that the game notes after the frame.
enum class Phase : std::uint8_t { resolver, dps, interaction, goal };

struct Event {
    EventId id;
    std::uint64_t frame = 0;
    std::uint32_t part = 1;  ///< of the frame, counted from 1 ...
    std::uint32_t parts = 1; ///< ... of so many
    Phase phase = Phase::resolver;
    std::string component;
    std::string event;
    std::vector<std::string> objects; ///< names, as objects may no longer exist when the trace is read
    std::vector<EventId> causes;      ///< ascending, without repeats
};

} // namespace trembler
