#include "insight/why/story/story.hpp"

#include "insight/why/story/trace_causes.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace trembler::insight {
namespace {

/// Whether an event follows from where its objects were placed.
bool hasPlacements(Event const& event) {
    auto const kind = kindOf(event);
    return kind && (*kind == StepKind::contact || isPull(*kind));
}

} // namespace

Story storyOf(std::span<Event const> events, EventId asked, SceneFacts const& facts) {
    auto const end =
        std::find_if(events.begin(), events.end(), [&](Event const& e) { return e.id == asked; });
    Story story;
    if (end == events.end()) {
        return story;
    }
    auto const target = static_cast<std::size_t>(end - events.begin());
    // The rest of its frame as well: currents are switched on side by side.
    std::size_t count = target + 1;
    while (count < events.size() && events[count].frame == end->frame) {
        ++count;
    }
    std::vector<std::set<std::size_t>> const causes = causesIn(events.first(count), facts);
    std::set<std::size_t> reached{target};
    std::vector<std::size_t> open{target};
    while (!open.empty()) {
        std::size_t const at = open.back();
        open.pop_back();
        for (std::size_t const cause : causes[at]) {
            if (cause < at && reached.insert(cause).second) {
                open.push_back(cause);
            }
        }
    }
    std::map<std::size_t, std::size_t> placed; // step of each placement
    for (std::size_t const i : reached) {
        if (!hasPlacements(events[i])) {
            continue;
        }
        for (std::string const& name : events[i].objects) {
            auto const at = facts.placementOf.find(name);
            if (at != facts.placementOf.end() && placed.emplace(at->second, story.steps.size()).second) {
                Step step;
                step.kind = StepKind::placed;
                step.component = "Player";
                step.what = "placed";
                step.objects = {name};
                story.steps.push_back(std::move(step));
            }
        }
    }
    std::map<std::size_t, std::size_t> stepOf;
    for (std::size_t const i : reached) {
        Event const& event = events[i];
        Step step = stepFor(event);
        std::set<std::size_t> because;
        for (std::size_t const cause : causes[i]) {
            if (cause < i) {
                because.insert(stepOf.at(cause));
            }
        }
        if (hasPlacements(event)) {
            for (std::string const& name : event.objects) {
                if (auto const at = facts.placementOf.find(name); at != facts.placementOf.end()) {
                    because.insert(placed.at(at->second));
                }
            }
        }
        step.because.assign(because.begin(), because.end());
        stepOf.emplace(i, story.steps.size());
        story.steps.push_back(std::move(step));
    }
    story.asked = story.steps.size() - 1;
    return story;
}

} // namespace trembler::insight
