#include "insight/why/story/bridges.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace trembler::insight {
namespace bridges {
namespace {

constexpr std::size_t unreached = std::numeric_limits<std::size_t>::max();

struct Reached {
    std::size_t steps = unreached; ///< that a story names, up to this event
    std::size_t from = unreached;  ///< the event before it; itself for the first ones
};

class Finder {
public:
    Finder(std::span<Event const> events, std::vector<std::size_t> const& first, bool alsoFirst)
        : events_(events), alsoFirst_(alsoFirst), reached_(events.size()) {
        for (std::size_t const i : first) {
            reached_[i] = {0, i};
        }
    }

    /// Reaches an event from the nearest of its causes, which must have been tried before. False if it has
    /// none.
    bool reach(std::size_t i) {
        if (!isFirst(i)) {
            Reached& best = reached_[i];
            for (std::size_t const cause : causesOf(i)) {
                if (reached_[cause].steps < best.steps) {
                    best = {reached_[cause].steps, cause};
                }
            }
            best.steps += best.from != unreached && kindOf(events_[i]) ? 1 : 0;
        }
        return reached_[i].from != unreached;
    }
    [[nodiscard]] bool isFirst(std::size_t i) const { return reached_[i].from == i; }

    [[nodiscard]] Bridge bridgeTo(std::size_t end) const {
        std::set<std::size_t> all;
        addPath(end, all);
        std::set<std::size_t> beside;
        for (std::size_t const i : all) {
            auto const kind = kindOf(events_[i]);
            for (std::size_t const cause : namedBefore(i)) {
                if ((kind == StepKind::on || kind == StepKind::off) &&
                    kindOf(events_[cause]) == StepKind::contact) {
                    addPath(cause, beside);
                }
            }
        }
        all.insert(beside.begin(), beside.end());
        Bridge bridge;
        for (std::size_t const i : all) {
            Bridge::Link link{i, {}};
            for (std::size_t const cause : namedBefore(i)) {
                if (all.contains(cause)) {
                    link.because.push_back(cause);
                }
            }
            bridge.links.push_back(std::move(link));
        }
        return bridge;
    }

private:
    [[nodiscard]] std::vector<std::size_t> causesOf(std::size_t i) const {
        std::vector<std::size_t> places;
        for (EventId const cause : events_[i].causes) {
            auto const end = events_.begin() + static_cast<std::ptrdiff_t>(i);
            auto const at = std::lower_bound(events_.begin(), end, cause,
                                             [](Event const& event, EventId id) { return event.id < id; });
            if (at != end && at->id == cause) {
                places.push_back(static_cast<std::size_t>(at - events_.begin()));
            }
        }
        return places;
    }

    /// The reached events that a story names and from which an event follows with none in between.
    [[nodiscard]] std::set<std::size_t> namedBefore(std::size_t i) const {
        std::set<std::size_t> found;
        std::set<std::size_t> seen;
        std::vector<std::size_t> open{i};
        while (!open.empty() && !isFirst(i)) {
            std::size_t const at = open.back();
            open.pop_back();
            for (std::size_t const cause : causesOf(at)) {
                if (reached_[cause].from == unreached || !seen.insert(cause).second) {
                    continue;
                }
                if (kindOf(events_[cause])) {
                    found.insert(cause);
                } else {
                    open.push_back(cause);
                }
            }
        }
        return found;
    }

    void addPath(std::size_t end, std::set<std::size_t>& path) const {
        std::size_t at = end;
        for (; !isFirst(at); at = reached_[at].from) {
            if (kindOf(events_[at])) {
                path.insert(at);
            }
        }
        if (alsoFirst_) {
            path.insert(at);
        }
    }

    std::span<Event const> events_;
    bool alsoFirst_;
    std::vector<Reached> reached_;
};

} // namespace
} // namespace bridges

std::vector<Bridge> bridgesFrom(std::span<Event const> events, std::vector<std::size_t> const& first,
                                bool alsoFirst, std::set<std::string> const& motors,
                                std::vector<std::string> const& asked, EventId last) {
    bridges::Finder finder(events, first, alsoFirst);
    std::vector<Bridge> found;
    std::set<std::string> devices;
    std::optional<std::size_t> current;
    for (std::size_t i = 0; i < events.size() && events[i].id < last; ++i) {
        if (!finder.reach(i) || events[i].objects.empty()) {
            continue;
        }
        auto const kind = kindOf(events[i]);
        std::string const& name = events[i].objects.front();
        bool const magnet = kind == StepKind::magnetOn || kind == StepKind::magnetOff;
        bool const motor = kind == StepKind::on && motors.contains(name);
        if ((magnet || motor) && found.size() < mostBridges && devices.insert(name).second) {
            found.push_back(finder.bridgeTo(i));
        } else if (!current && !motor && (kind == StepKind::on || kind == StepKind::off) &&
                   std::find(asked.begin(), asked.end(), name) != asked.end()) {
            current = i;
        }
    }
    if (current) {
        found.push_back(finder.bridgeTo(*current));
    }
    return found;
}

} // namespace trembler::insight
