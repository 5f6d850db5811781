#include "insight/why/story/deed_steps.hpp"

#include "insight/why/story/bridges.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace trembler::insight {
namespace {

StepKind kindOfInput(PlayerInput::Kind kind) {
    return kind == PlayerInput::Kind::cut      ? StepKind::cut
           : kind == PlayerInput::Kind::remove ? StepKind::removed
                                               : StepKind::grabbed;
}

/// The words of the trace for it.
std::string_view wordOfInput(PlayerInput::Kind kind) {
    return kind == PlayerInput::Kind::cut ? "cut" : kind == PlayerInput::Kind::remove ? "removed" : "grabbed";
}

/// The event of a deed; nothing if the deed had no effect, as one on an object that is gone.
EventId eventOfDeed(Step const& deed, std::span<Event const> events) {
    auto const at = std::find_if(events.begin(), events.end(), [&](Event const& event) {
        return event.frame == deed.frame && event.event == deed.what && event.objects == deed.objects;
    });
    return at == events.end() ? EventId{} : at->id;
}

/// A name for each placement: the shortest of its pieces'.
std::map<std::size_t, std::string> placedIn(SceneFacts const& facts) {
    std::map<std::size_t, std::string> all;
    for (auto const& [piece, placement] : facts.placementOf) {
        std::string& name = all[placement];
        if (name.empty() || piece.size() < name.size()) {
            name = piece;
        }
    }
    return all;
}

Step stepBefore(StepKind kind, std::string what, std::vector<std::string> objects) {
    Step step;
    step.kind = kind;
    step.component = "Player";
    step.what = std::move(what);
    step.objects = std::move(objects);
    step.traced = false;
    return step;
}

/// Placements that the story does not have, and wires, of which the trace says nothing.
std::vector<Step> stepsBefore(Story const& story, Solution const& solution, SceneFacts const& facts) {
    std::set<std::size_t> known;
    for (Step const& step : story.steps) {
        if (step.kind == StepKind::placed) {
            known.insert(facts.placementOf.at(step.objects.front()));
        }
    }
    std::vector<Step> steps;
    for (auto const& [placement, name] : placedIn(facts)) {
        if (!known.contains(placement)) {
            steps.push_back(stepBefore(StepKind::placed, "placed", {name}));
        }
    }
    for (LevelConnection const& wire : solution.wires) {
        steps.push_back(stepBefore(StepKind::wired, "connected by the player", {wire.a, wire.b}));
    }
    return steps;
}

/// A story to which deeds are added that the trace does not connect with it, with their bridges.
class Inserted {
public:
    Inserted(Story const& story, std::span<Event const> events, SceneFacts const& facts)
        : story_(story), events_(events), facts_(facts) {
        for (std::size_t i = 0; i < story.steps.size(); ++i) {
            Entry entry{story.steps[i], {}};
            for (std::size_t const cause : story.steps[i].because) {
                entry.because.push_back(cause);
            }
            entries_.push_back(std::move(entry));
        }
    }

    void add(Step const& deed) {
        std::size_t const own = entries_.size();
        std::vector<std::size_t>& ends = ends_[own];
        entries_.push_back({deed, {}});
        std::map<std::size_t, std::size_t> entryOf; // of an event of its bridges
        for (Bridge const& bridge : bridgesOf(deed)) {
            for (Bridge::Link const& link : bridge.links) {
                Event const& event = events_[link.event];
                bool const known = std::any_of(story_.steps.begin(), story_.steps.end(),
                                               [&](Step const& step) { return step.event == event.id; });
                // A step that is known would join the story, so the trace connects them after all.
                if (known || entryOf.contains(link.event)) {
                    continue;
                }
                Step step = stepFor(event);
                step.bridge = true;
                std::vector<std::size_t> because;
                for (std::size_t const cause : link.because) {
                    if (auto const at = entryOf.find(cause); at != entryOf.end()) {
                        because.push_back(at->second);
                    }
                }
                entryOf.emplace(link.event, entries_.size());
                entries_.push_back({std::move(step), because.empty() ? std::vector{own} : because});
            }
            if (auto const end = entryOf.find(bridge.links.back().event); end != entryOf.end()) {
                ends.push_back(end->second);
            }
        }
    }

    /// In the order of the trace, placements and wires first.
    [[nodiscard]] Story story() const {
        std::vector<std::size_t> order(entries_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return entries_[a].step.event < entries_[b].step.event;
        });
        std::vector<std::size_t> placeOf(entries_.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            placeOf[order[i]] = i;
        }
        Story made;
        for (std::size_t const i : order) {
            Step step = entries_[i].step;
            step.because.clear();
            for (std::size_t const cause : entries_[i].because) {
                step.because.push_back(placeOf[cause]);
            }
            std::sort(step.because.begin(), step.because.end());
            made.steps.push_back(std::move(step));
        }
        made.asked = placeOf[story_.asked];
        for (auto const& [deed, ends] : ends_) {
            for (std::size_t const end : ends) {
                made.bridges[placeOf[deed]].push_back(placeOf[end]);
            }
        }
        return made;
    }

private:
    struct Entry {
        Step step;
        std::vector<std::size_t> because; ///< places in entries_
    };

    /// Where the trace says what followed from the deed: of a placement, what its pieces touched.
    [[nodiscard]] std::vector<Bridge> bridgesOf(Step const& deed) const {
        bool const placed = deed.kind == StepKind::placed;
        std::vector<std::size_t> first;
        for (std::size_t i = 0; i < events_.size(); ++i) {
            if (placed ? kindOf(events_[i]) == StepKind::contact && isPieceOf(deed, events_[i])
                       : events_[i].id == deed.event) {
                first.push_back(i);
            }
        }
        Step const& asked = story_.askedStep();
        return bridgesFrom(events_, first, placed, facts_.motors, asked.objects, asked.event);
    }

    [[nodiscard]] bool isPieceOf(Step const& deed, Event const& event) const {
        auto const placement = facts_.placementOf.at(deed.objects.front());
        return std::any_of(event.objects.begin(), event.objects.end(), [&](std::string const& name) {
            auto const at = facts_.placementOf.find(name);
            return at != facts_.placementOf.end() && at->second == placement;
        });
    }

    Story const& story_;
    std::span<Event const> events_;
    SceneFacts const& facts_;
    std::vector<Entry> entries_;                           // the story's, then the others
    std::map<std::size_t, std::vector<std::size_t>> ends_; // of each deed that was added, of its bridges
};

} // namespace

bool isDeed(StepKind kind) {
    return kind == StepKind::placed || kind == StepKind::wired || kind == StepKind::grabbed ||
           kind == StepKind::cut || kind == StepKind::removed;
}

DeedFinder::DeedFinder(Solution const& solution)
    : solution_(solution), deeds_(deedsOf(solution)), found_(deeds_.size()) {}

Step DeedFinder::stepOf(Deed const& deed) const {
    RecordedInput const& input = solution_.inputs[deed.inputs.front()];
    Step step = stepBefore(kindOfInput(input.kind), std::string(wordOfInput(input.kind)), {input.object});
    step.frame = input.frame;
    if (input.kind == PlayerInput::Kind::cut) {
        step.objects.push_back(input.other);
    }
    return step;
}

Deed const* DeedFinder::find(Step const& step) {
    for (std::size_t i = 0; i < deeds_.size(); ++i) {
        Step const own = stepOf(deeds_[i]);
        if (!found_[i] && own.kind == step.kind && own.frame == step.frame && own.objects == step.objects) {
            found_[i] = true;
            return &deeds_[i];
        }
    }
    return nullptr;
}

std::vector<Step> DeedFinder::others() const {
    std::vector<Step> steps;
    for (std::size_t i = 0; i < deeds_.size(); ++i) {
        if (!found_[i]) {
            steps.push_back(stepOf(deeds_[i]));
        }
    }
    std::stable_sort(steps.begin(), steps.end(),
                     [](Step const& a, Step const& b) { return a.frame < b.frame; });
    return steps;
}

Story withDeeds(Story const& story, Solution const& solution, SceneFacts const& facts,
                std::span<Event const> events) {
    if (story.steps.empty()) {
        return story;
    }
    DeedFinder finder(solution);
    for (Step const& step : story.steps) {
        (void)finder.find(step);
    }
    std::vector<Step> more = stepsBefore(story, solution, facts);
    for (Step& deed : finder.others()) {
        deed.event = eventOfDeed(deed, events);
        if (deed.event && deed.event < story.askedStep().event) {
            more.push_back(std::move(deed));
        }
    }
    Inserted inserted(story, events, facts);
    for (Step const& deed : more) {
        inserted.add(deed);
    }
    return inserted.story();
}

} // namespace trembler::insight
