#include "insight/kind/cause_graph.hpp"

#include "runtime/trace/tracer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace trembler::insight {
namespace {

void addChains(CauseGraph& graph, LevelRun const& run) {
    Tracer const* const tracer = run.world().tracer();
    if (tracer == nullptr) {
        return;
    }
    std::set<EventId> events;
    for (EventId const cause : run.judge().causes(run.world())) {
        for (EventId const event : tracer->chain(cause)) {
            events.insert(event);
        }
    }
    for (EventId const id : events) {
        Event const* const event = tracer->find(id);
        if (event == nullptr) {
            continue;
        }
        for (EventId const causeId : event->causes) {
            Event const* const cause = tracer->find(causeId);
            if (cause != nullptr && cause->component != event->component) {
                graph.links.emplace(cause->component, event->component);
            }
        }
    }
}

} // namespace

CauseGraph causeGraphOf(LevelRuns const& runs, Solution const& solution, std::uint64_t frames) {
    CauseGraph graph;
    RunObserver observer;
    observer.end = [&](LevelRun const& run) {
        graph.solves = run.judge().solved();
        if (!graph.solves) {
            return;
        }
        using Kind = PlayerInput::Kind;
        for (RecordedInput const& input : run.inputs()) {
            if (input.kind == Kind::grab || input.kind == Kind::cut || input.kind == Kind::remove) {
                graph.deeds.emplace(playerInputNames[static_cast<std::size_t>(input.kind)]);
            }
        }
        for (Placement const& placement : solution.placements) {
            graph.parts.insert(placement.part);
        }
        if (!solution.wires.empty()) {
            graph.parts.emplace(playersWire);
        }
        addChains(graph, run);
    };
    (void)runs.run({solution, {}}, {.frames = frames, .trace = true}, observer);
    return graph;
}

bool differ(CauseGraph const& a, CauseGraph const& b) {
    if (a.deeds != b.deeds || a.links != b.links) {
        return true;
    }
    auto const within = [](std::set<std::string> const& few, std::set<std::string> const& many) {
        return std::includes(many.begin(), many.end(), few.begin(), few.end());
    };
    return !within(a.parts, b.parts) && !within(b.parts, a.parts);
}

std::string inWords(CauseGraph const& graph) {
    std::set<std::string> means = graph.parts;
    means.insert(graph.deeds.begin(), graph.deeds.end());
    std::set<std::string> interactions;
    for (auto const& [cause, effect] : graph.links) {
        for (std::string const& title : {cause, effect}) {
            if (title.find("<-") != std::string::npos) {
                interactions.insert(title);
            }
        }
    }
    std::string words = means.empty() ? "nothing placed" : fmt::format("{}", fmt::join(means, " + "));
    if (!interactions.empty()) {
        words += fmt::format("; {}", fmt::join(interactions, ", "));
    }
    return words;
}

std::string toText(CauseGraph const& graph) {
    return nlohmann::json{
        {"solves", graph.solves}, {"parts", graph.parts}, {"deeds", graph.deeds}, {"links", graph.links}}
        .dump();
}

CauseGraph causeGraphFrom(std::string const& text) {
    nlohmann::json const all = nlohmann::json::parse(text);
    CauseGraph graph;
    graph.solves = all.at("solves").get<bool>();
    graph.parts = all.at("parts").get<std::set<std::string>>();
    graph.deeds = all.at("deeds").get<std::set<std::string>>();
    graph.links = all.at("links").get<std::set<std::pair<std::string, std::string>>>();
    return graph;
}

} // namespace trembler::insight
