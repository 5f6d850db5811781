// The consequences, in a trace, of a deed that it does not connect with what was asked about.
#pragma once

#include "insight/why/story/story.hpp"

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace trembler::insight {

/// The events that led to the event of one device, by their places in the trace, ascending; the device's
/// event is the last.
struct Bridge {
    struct Link {
        std::size_t event = 0;
        std::vector<std::size_t> because; ///< events of the bridge; empty: the deed itself
    };
    std::vector<Link> links;
};

/// The bridges from some events to the devices that are switched because of them, in the order of the trace:
/// of every magnet the first switching, of every one of these motors the first current; at most
/// `mostBridges`. Last, of the asked objects the first whose current begins or ends. Each by the fewest
/// steps, and with all contacts that switch a current together. Only events that a story names (kindOf()),
/// without the first ones unless they are named by `alsoFirst`; none from the event `last` on. O(causes of
/// all events).
[[nodiscard]] std::vector<Bridge> bridgesFrom(std::span<Event const> events,
                                              std::vector<std::size_t> const& first, bool alsoFirst,
                                              std::set<std::string> const& motors,
                                              std::vector<std::string> const& asked, EventId last);
inline constexpr std::size_t mostBridges = 4;

} // namespace trembler::insight
