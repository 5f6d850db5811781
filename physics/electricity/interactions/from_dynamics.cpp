#include "physics/electricity/interactions/from_dynamics.hpp"

#include <algorithm>

namespace trembler {
namespace {

// The pairs that this caller connects in the graph.
void gatherPairs(Column<ElectricityGraph> const& graph, CallerId caller, std::vector<TouchingPair>& pairs) {
    for (std::size_t r = 0; r < graph.size(); ++r) {
        ObjectId const owner = graph.owners()[r];
        for (ElectricityGraph::Connection const& connection : graph.values()[r].connections) {
            if (owner < connection.to && connection.counts.of(caller) > 0) {
                pairs.push_back({owner, connection.to, {}});
            }
        }
    }
}

EventId endOf(TouchingPair const& pair, std::vector<TouchingPair> const& ended) {
    auto const at = std::lower_bound(ended.begin(), ended.end(), pair);
    return at != ended.end() && *at == pair ? at->event : EventId{};
}

} // namespace

void ElectricityFromDynamics::apply(Access& access) {
    Contacts const& contacts = access.read<Contacts>();
    auto const& conductors = access.read<Conductor>();
    if (access.firstTime()) {
        gatherPairs(access.read<ElectricityGraph>(), access.caller(), connected_);
    }
    touching_.clear();
    for (TouchingPair const& pair : contacts.current) {
        if (conductors.has(pair.a) && conductors.has(pair.b)) {
            touching_.push_back(pair);
        }
    }
    auto const begin = [&](TouchingPair const& pair) {
        access.call(AddConnection{{pair.a, pair.b}}, pair.event);
    };
    auto const end = [&](TouchingPair const& pair) {
        if (conductors.has(pair.a) && conductors.has(pair.b)) { // otherwise it is removed already
            access.call(RemoveConnection{{pair.a, pair.b}}, endOf(pair, contacts.ended));
        }
    };
    auto before = connected_.begin();
    auto now = touching_.begin();
    while (before != connected_.end() || now != touching_.end()) {
        if (now == touching_.end() || (before != connected_.end() && *before < *now)) {
            end(*before++);
        } else if (before == connected_.end() || *now < *before) {
            begin(*now++);
        } else {
            ++before;
            ++now;
        }
    }
    connected_.swap(touching_);
}

} // namespace trembler
