#include "insight/why/story/bridges.hpp"

#include <algorithm>
#include <limits>

namespace trembler::insight {
namespace bridges {
namespace {

constexpr std::size_t unreached = std::numeric_limits<std::size_t>::max();

struct Reached {
    std::size_t steps = unreached; ///< that a story names, up to this event
    std::size_t from = unreached;  ///< the event before it; itself for the first ones
};

/// Reaches an event from the nearest of its causes.
Reached reach(std::span<Event const> events, std::vector<Reached> const& reached, std::size_t i) {
    Reached best;
    for (EventId const cause : events[i].causes) {
        auto const end = events.begin() + static_cast<std::ptrdiff_t>(i);
        auto const at = std::lower_bound(events.begin(), end, cause,
                                         [](Event const& event, EventId id) { return event.id < id; });
        if (at == end || at->id != cause) {
            continue;
        }
        auto const place = static_cast<std::size_t>(at - events.begin());
        if (reached[place].steps < best.steps) {
            best = {reached[place].steps, place};
        }
    }
    if (best.from != unreached) {
        best.steps += kindOf(events[i]) ? 1 : 0;
    }
    return best;
}

std::vector<std::size_t> pathTo(std::span<Event const> events, std::vector<Reached> const& reached,
                                std::size_t end, bool alsoFirst) {
    std::vector<std::size_t> path;
    std::size_t at = end;
    for (; reached[at].from != at; at = reached[at].from) {
        if (kindOf(events[at])) {
            path.push_back(at);
        }
    }
    if (alsoFirst) {
        path.push_back(at);
    }
    std::reverse(path.begin(), path.end());
    return path;
}

} // namespace
} // namespace bridges

std::vector<std::size_t> bridgeFrom(std::span<Event const> events, std::vector<std::size_t> const& first,
                                    bool alsoFirst, std::vector<std::string> const& objects, EventId last) {
    using bridges::unreached;
    std::vector<bridges::Reached> reached(events.size());
    for (std::size_t const i : first) {
        reached[i] = {0, i};
    }
    std::size_t current = unreached;
    for (std::size_t i = 0; i < events.size() && events[i].id < last; ++i) {
        if (reached[i].from != i) {
            reached[i] = bridges::reach(events, reached, i);
        }
        if (reached[i].from == unreached) {
            continue;
        }
        auto const kind = kindOf(events[i]);
        if (kind == StepKind::magnetOn || kind == StepKind::magnetOff) {
            return bridges::pathTo(events, reached, i, alsoFirst);
        }
        bool const switches = kind == StepKind::on || kind == StepKind::off;
        if (switches && current == unreached && !events[i].objects.empty() &&
            std::find(objects.begin(), objects.end(), events[i].objects.front()) != objects.end()) {
            current = i;
        }
    }
    return current == unreached ? std::vector<std::size_t>{}
                                : bridges::pathTo(events, reached, current, alsoFirst);
}

} // namespace trembler::insight
