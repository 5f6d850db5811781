// One line of the account that the machine gives of a run: what happened, and because of what.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

namespace trembler {

/// Names an event before the frame's events are gathered: frame, component, chunk and sequence number in one
/// number that depends on no thread. Ordered as events are listed. 0 is "no event".
struct EventId {
    std::uint64_t value = 0;

    [[nodiscard]] explicit constexpr operator bool() const { return value != 0; }
    friend constexpr auto operator<=>(EventId, EventId) = default;
};

/// Where in a frame an event belongs; `goal` is what the game notes after the frame.
enum class Phase : std::uint8_t { resolver, dps, interaction, goal };

struct Event {
    EventId id;
    std::uint64_t frame = 0;
    Phase phase = Phase::resolver;
    std::string component;
    std::string event;
    std::vector<std::string> objects; ///< names, as objects may be gone when somebody reads
    std::vector<EventId> causes;      ///< ascending, without repeats
};

} // namespace trembler
