#include "physics/electricity/core/electricity_resolver.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

namespace trembler {
namespace {

// A reader that missed more entries than this reads the whole graph; the limit affects memory only.
constexpr std::size_t journalLimit = 4096;

[[nodiscard]] std::vector<ObjectId> without(std::span<ObjectId const> these,
                                            std::span<ObjectId const> those) {
    std::vector<ObjectId> rest;
    std::set_difference(these.begin(), these.end(), those.begin(), those.end(), std::back_inserter(rest));
    return rest;
}

/// Removes connections of the graph, each of which is named once. All together, because a row is a sorted
/// list: removing the connections of a hub one after the other would take the square of their number.
void removeConnections(Column<ElectricityGraph>& graph, std::vector<std::pair<ObjectId, ObjectId>> pairs) {
    for (std::size_t i = pairs.size(); i-- > 0;) {
        pairs.emplace_back(pairs[i].second, pairs[i].first);
    }
    std::sort(pairs.begin(), pairs.end());
    for (auto next = pairs.begin(); next != pairs.end();) {
        ObjectId const vertex = next->first;
        // Both lists ascend, so one pass finds their common entries.
        std::erase_if(graph[vertex].connections, [&](ElectricityGraph::Connection const& connection) {
            while (next != pairs.end() && next->first == vertex && next->second < connection.to) {
                ++next;
            }
            return next != pairs.end() && next->first == vertex && next->second == connection.to;
        });
        next = std::find_if(next, pairs.end(), [&](auto const& pair) { return pair.first != vertex; });
    }
    graph.touch();
}

} // namespace

void ElectricityResolver::advance(Access& access) {
    touched_.clear();
    followObjects(access);
    followCallers(access);
    blowFuses(access);
    induceVoltages(access);
    carryOutCalls(access);
    publish(access);
    first_ = false;
}

void ElectricityResolver::followObjects(Access& access) {
    std::array<std::uint64_t, 3> const versions{access.read<Conductor>().version(),
                                                access.read<ElectricalSource>().version(),
                                                access.read<ElectricalReturn>().version()};
    if (!first_ && versions == seen_) {
        return;
    }
    if (first_ || versions[0] != seen_[0]) {
        followVertices(access);
    }
    followNetworks(access);
    seen_ = versions;
}

// New conductors become vertices; vertices that are no longer conductors are removed with their connections.
void ElectricityResolver::followVertices(Access& access) {
    std::span<ObjectId const> const now = access.read<Conductor>().owners();
    std::vector<ObjectId> const missing = without(now, access.read<ElectricityGraph>().owners());
    if (!missing.empty()) {
        addVertices(access.write<ElectricityGraph>(), missing);
    }
    std::vector<ObjectId> const surplus = without(access.read<ElectricityGraph>().owners(), now);
    if (!surplus.empty()) {
        access.write<ElectricityGraph>().removeAll(surplus);
    }
    std::vector<ObjectId> const gone = without(vertices_, now);
    if (first_ || !gone.empty()) {
        dropLooseEnds(access);
    }
    for (ObjectId const id : gone) {
        touch(id);
    }
    for (ObjectId const id : without(now, vertices_)) {
        touch(id);
    }
    if (first_ || !gone.empty() || vertices_.size() != now.size()) {
        vertices_.assign(now.begin(), now.end());
    }
}

// Walks over the whole graph, in frames in which a conductor disappeared. The row of a destroyed object no
// longer exists, so the objects that were connected to it can be found by their own rows only.
void ElectricityResolver::dropLooseEnds(Access& access) {
    auto const& graph = access.read<ElectricityGraph>();
    for (std::uint32_t r = 0; r < graph.size(); ++r) {
        auto const loose = [&](ElectricityGraph::Connection const& c) { return !graph.has(c.to); };
        auto const& connections = graph.values()[r].connections;
        if (std::none_of(connections.begin(), connections.end(), loose)) {
            continue;
        }
        ObjectId const owner = graph.owners()[r];
        for (ElectricityGraph::Connection const& connection : connections) {
            if (loose(connection)) {
                touch(owner, access.event("disconnected", {owner, connection.to}, {}));
            }
        }
        std::erase_if(access.write<ElectricityGraph>().values()[r].connections, loose);
    }
}

// An object whose part in the networks has changed may switch other objects on or off.
void ElectricityResolver::followNetworks(Access& access) {
    std::vector<NetworkPart> now;
    auto const& conductors = access.read<Conductor>();
    for (std::size_t r = 0; r < conductors.size(); ++r) {
        if (!conductors.values()[r].network.empty()) {
            now.push_back(
                {conductors.owners()[r], NetworkPart::Kind::conductor, conductors.values()[r].network});
        }
    }
    auto const add = [&](auto const& column, NetworkPart::Kind kind) {
        for (std::size_t r = 0; r < column.size(); ++r) {
            now.push_back({column.owners()[r], kind, column.values()[r].network});
        }
    };
    add(access.read<ElectricalSource>(), NetworkPart::Kind::source);
    add(access.read<ElectricalReturn>(), NetworkPart::Kind::returning);
    std::sort(now.begin(), now.end());
    std::vector<NetworkPart> different;
    std::set_symmetric_difference(now.begin(), now.end(), parts_.begin(), parts_.end(),
                                  std::back_inserter(different));
    for (NetworkPart const& part : different) {
        touch(part.object);
    }
    parts_ = std::move(now);
}

// An interaction that was removed because the scene no longer needs it cannot remove the connections that it
// added. So they are removed here, as its held calls are; if it is constructed again it begins with none.
// Walks over the whole graph, in the frame after an interaction was removed.
void ElectricityResolver::followCallers(Access& access) {
    std::span<CallerId const> const now = access.callers();
    if (!first_ && std::equal(now.begin(), now.end(), callers_.begin(), callers_.end())) {
        return;
    }
    bool const somebodyWent =
        first_ || !std::includes(now.begin(), now.end(), callers_.begin(), callers_.end());
    callers_.assign(now.begin(), now.end());
    if (!somebodyWent) {
        return;
    }
    auto const& graph = access.read<ElectricityGraph>();
    std::vector<VertexPair> left;
    for (std::uint32_t r = 0; r < graph.size(); ++r) {
        ObjectId const owner = graph.owners()[r];
        for (ElectricityGraph::Connection const& connection : graph.values()[r].connections) {
            if (owner < connection.to && !connection.counts.onlyBy(now)) {
                left.emplace_back(owner, connection.to);
            }
        }
    }
    std::vector<VertexPair> removed;
    for (auto const& [a, b] : left) {
        CallerCounts kept = connectionBetween(graph, a, b);
        kept.keepOnly(now);
        if (kept.any()) {
            setConnection(access.write<ElectricityGraph>(), a, b, kept);
        } else {
            removed.emplace_back(a, b);
            EventId const event = access.event("disconnected", {a, b}, {});
            touch(a, event);
            touch(b, event);
        }
    }
    if (!removed.empty()) {
        removeConnections(access.write<ElectricityGraph>(), std::move(removed));
    }
}

// A blown fuse stays a vertex, but an isolated one. A level may state a blown fuse with wires.
void ElectricityResolver::blowFuses(Access& access) {
    struct Blown {
        ObjectId fuse;
        EventId cause;
    };
    auto const& fuses = access.read<Fuse>();
    std::vector<Blown> blown;
    access.forCalls<BlowFuse>([&](BlowFuse const& call, CallOrigin origin) {
        if (Fuse const* const fuse = fuses.find(call.fuse); fuse != nullptr && !fuse->blown) {
            blown.push_back({call.fuse, origin.cause});
        }
    });
    std::sort(blown.begin(), blown.end(), [](Blown const& x, Blown const& y) {
        return std::tie(x.fuse, x.cause) < std::tie(y.fuse, y.cause);
    });
    auto const same = [](Blown const& x, Blown const& y) { return x.fuse == y.fuse; };
    blown.erase(std::unique(blown.begin(), blown.end(), same), blown.end());
    for (Blown& one : blown) {
        access.write<Fuse>()[one.fuse].blown = true;
        one.cause = access.event("blown", std::span(&one.fuse, 1), std::span(&one.cause, 1));
    }
    if (first_) {
        for (std::size_t r = 0; r < fuses.size(); ++r) {
            if (fuses.values()[r].blown) {
                blown.push_back({fuses.owners()[r], {}});
            }
        }
    }
    std::set<ObjectId> isolated;
    std::vector<VertexPair> removed;
    for (Blown const& one : blown) {
        ElectricityGraph const* const row = access.read<ElectricityGraph>().find(one.fuse);
        if (row == nullptr || isolated.contains(one.fuse)) {
            continue;
        }
        for (ElectricityGraph::Connection const& connection : row->connections) {
            if (isolated.contains(connection.to)) {
                continue; // removed with that fuse
            }
            removed.emplace_back(one.fuse, connection.to);
            std::array const pair{one.fuse, connection.to};
            EventId const event = access.event("disconnected", pair, std::span(&one.cause, 1));
            touch(one.fuse, event);
            touch(connection.to, event);
        }
        isolated.insert(one.fuse);
    }
    if (!removed.empty()) {
        removeConnections(access.write<ElectricityGraph>(), std::move(removed));
    }
}

bool ElectricityResolver::conducts(Access& access, ObjectId id) {
    Fuse const* const fuse = access.read<Fuse>().find(id);
    return access.read<ElectricityGraph>().has(id) && (fuse == nullptr || !fuse->blown);
}

void ElectricityResolver::carryOutCalls(Access& access) {
    changes_.clear();
    auto const note = [&](auto const& call, CallerId caller, int delta, CallOrigin const& origin) {
        if (call.a != call.b && conducts(access, call.a) && conducts(access, call.b)) { // conductors only
            auto const [a, b] = std::minmax(call.a, call.b);
            changes_.push_back({a, b, caller, delta, origin.cause});
        }
    };
    access.forCalls<AddConnection>([&](AddConnection const& call, CallOrigin const& origin) {
        note(call, origin.caller, call.delta(), origin);
    });
    access.forCalls<RemoveConnection>([&](RemoveConnection const& call, CallOrigin const& origin) {
        note(call, origin.caller, call.delta(), origin);
    });
    access.forCalls<CutWire>(
        [&](CutWire const& call, CallOrigin const& origin) { note(call, CallerId::level(), -1, origin); });
    followHeld(access);
    std::sort(changes_.begin(), changes_.end(), [](Change const& x, Change const& y) {
        return std::tie(x.a, x.b, x.caller, x.event, x.delta) <
               std::tie(y.a, y.b, y.caller, y.event, y.delta);
    });
    std::vector<VertexPair> removed;
    for (auto from = changes_.begin(); from != changes_.end();) {
        auto const to = std::find_if(from, changes_.end(),
                                     [&](Change const& c) { return c.a != from->a || c.b != from->b; });
        changePair(access, {from, to}, removed);
        from = to;
    }
    if (!removed.empty()) {
        removeConnections(access.write<ElectricityGraph>(), std::move(removed));
    }
}

// Applies all changes of one pair in one frame. Adding up before clamping makes the order of calls
// irrelevant.
void ElectricityResolver::changePair(Access& access, std::span<Change const> changes,
                                     std::vector<VertexPair>& removed) {
    ObjectId const a = changes.front().a;
    ObjectId const b = changes.front().b;
    CallerCounts const before = connectionBetween(access.read<ElectricityGraph>(), a, b);
    CallerCounts after = before;
    for (auto from = changes.begin(); from != changes.end();) {
        CallerId const caller = from->caller;
        std::int64_t sum = 0;
        for (; from != changes.end() && from->caller == caller; ++from) {
            sum += from->delta;
        }
        after.add(caller, sum);
    }
    if (after == before) {
        return;
    }
    if (after.any()) {
        setConnection(access.write<ElectricityGraph>(), a, b, after);
    } else {
        removed.emplace_back(a, b);
    }
    if (after.any() == before.any()) {
        return; // the callers have changed, but not whether the pair is connected
    }
    std::vector<EventId> causes;
    if (access.tracing()) {
        for (Change const& change : changes) {
            if ((change.delta > 0) == after.any()) {
                causes.push_back(change.event);
            }
        }
    }
    std::array const pair{a, b};
    EventId const event = access.event(after.any() ? "connected" : "disconnected", pair, causes);
    touch(a, event);
    touch(b, event);
}

void ElectricityResolver::publish(Access& access) {
    if (!first_ && touched_.empty()) {
        return;
    }
    GraphChanges& changes = access.provide<GraphChanges>();
    if (first_ || changes.journal.size() > journalLimit) {
        changes.journal.clear();
        changes.forgotten = first_ ? changes.number + 1 : changes.number;
    }
    ++changes.number;
    for (GraphChanges::Touched& touched : touched_) {
        touched.number = changes.number;
    }
    if (!first_) {
        changes.journal.insert(changes.journal.end(), touched_.begin(), touched_.end());
    }
}

} // namespace trembler
