#include "insight/why/deed_steps.hpp"

#include <algorithm>
#include <map>
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
    std::vector<Step> more = finder.others();
    std::erase_if(more, [&](Step& deed) {
        deed.event = eventOfDeed(deed, events);
        return !deed.event || deed.frame > story.askedStep().frame;
    });
    Story made;
    made.steps = stepsBefore(story, solution, facts);
    std::vector<std::size_t> placeOf; // of each of the story's steps
    std::size_t next = 0;             // of `more`
    for (Step const& step : story.steps) {
        for (; next < more.size() && step.kind != StepKind::placed && more[next].frame <= step.frame;
             ++next) {
            made.steps.push_back(more[next]);
        }
        placeOf.push_back(made.steps.size());
        made.steps.push_back(step);
        for (std::size_t& cause : made.steps.back().because) {
            cause = placeOf[cause];
        }
    }
    made.asked = placeOf[story.asked];
    return made;
}

} // namespace trembler::insight
