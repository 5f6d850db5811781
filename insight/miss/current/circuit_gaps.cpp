#include "insight/miss/current/circuit_gaps.hpp"

#include "audio/effect/properties/acoustics.hpp"
#include "insight/miss/current/switched_links.hpp"
#include "insight/miss/current/two_paths.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shapes/placed_shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "physics/electricity/properties/scene_level.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/entry.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace trembler::insight {
namespace {

/// m, as of a generator at rest: a path by way of a cut wire and a further gap is not the nearest one as long
/// as the object's own circuit has a reason.
constexpr double cutCost = 0.5;

template <class P>
std::uint64_t versionOf(Store const& store) {
    auto const* const column = store.findColumn<P>();
    return column == nullptr ? 0 : column->version() + column->structureVersion();
}

/// A conductor with a shape, as it lies.
struct PlacedConductor {
    PlacedShape placed;
    Vec2 lower; ///< m, of the upright rectangle around it
    Vec2 upper;
};

std::optional<PlacedConductor> placedConductorOf(Store const& store, ObjectId id) {
    std::optional<PlacedShape> const placed = placedShapeOf(store, id);
    if (!placed) {
        return std::nullopt;
    }
    auto const [lower, upper] = extentOf(*placed);
    return PlacedConductor{*placed, lower, upper};
}

/// No more than the distance of the two.
double leastDistance(PlacedConductor const& a, PlacedConductor const& b) {
    double const x = std::max({0.0, a.lower.x - b.upper.x, b.lower.x - a.upper.x});
    double const y = std::max({0.0, a.lower.y - b.upper.y, b.lower.y - a.upper.y});
    return std::hypot(x, y);
}

std::vector<std::string> networksOf(Store const& store) {
    std::set<std::string> names;
    if (auto const* const sources = store.findColumn<ElectricalSource>()) {
        for (ElectricalSource const& source : sources->values()) {
            names.insert(source.network);
        }
    }
    return {names.begin(), names.end()};
}

/// Whether the gap lies between the source and the return of a network that is not this one, as the ends of a
/// battery in the circuit of another one.
bool areEndsOfOther(Store const& store, CircuitGap const& gap, std::string const& network) {
    auto const isBetween = [&](ObjectId from, ObjectId to) {
        ElectricalSource const* const source = entryOf<ElectricalSource>(store, from);
        ElectricalReturn const* const back = entryOf<ElectricalReturn>(store, to);
        return source != nullptr && back != nullptr && source->network == back->network &&
               source->network != network;
    };
    return gap.reason == GapReason::apart && (isBetween(gap.a, gap.b) || isBetween(gap.b, gap.a));
}

CollisionGroups groupsOf(Store const& store, ObjectId id) {
    CollisionGroups const* const stated = entryOf<CollisionGroups>(store, id);
    return stated == nullptr ? CollisionGroups{} : *stated;
}

/// Whether a touch of the two is a likely way to close a circuit: not of objects that pass through each
/// other, and not of a coil, which is connected by wires.
bool isContact(Store const& store, ObjectId a, ObjectId b) {
    return canHit(groupsOf(store, a), groupsOf(store, b)) && entryOf<Electromagnet>(store, a) == nullptr &&
           entryOf<Electromagnet>(store, b) == nullptr;
}

} // namespace

std::string_view nameOf(GapReason reason) {
    switch (reason) {
    case GapReason::slow:
        return "slow";
    case GapReason::quiet:
        return "quiet";
    case GapReason::blown:
        return "blown";
    case GapReason::foreign:
        return "foreign";
    case GapReason::cut:
        return "cut";
    case GapReason::apart:
        break;
    }
    return "apart";
}

void CircuitSight::rememberWires(World const& world) {
    auto const* const graph = world.store().findColumn<ElectricityGraph>();
    for (ObjectId const id : graph == nullptr ? std::span<ObjectId const>() : graph->owners()) {
        for (ElectricityGraph::Connection const& connection : graph->find(id)->connections) {
            if (id < connection.to && connection.counts.of(CallerId::level()) > 0) {
                wires_.emplace(id, connection.to);
            }
        }
    }
}

void CircuitSight::look(World const& world) {
    Store const& store = world.store();
    std::uint64_t const positions = versionOf<Position>(store);
    std::uint64_t const rotations = versionOf<Rotation>(store);
    std::uint64_t const graph = versionOf<ElectricityGraph>(store);
    auto const* const sensors = store.findColumn<SoundSensor>();
    bool const hears = sensors != nullptr && sensors->size() > 0; // sounds fade without any motion
    bool const still = positions == positions_ && rotations == rotations_ && !hears;
    if (known_ && graph == graph_ && (still || world.frame() < lookedIn_ + patience)) {
        return;
    }
    known_ = true;
    lookedIn_ = world.frame();
    positions_ = positions;
    rotations_ = rotations;
    graph_ = graph;
    cuts_.clear();
    links_.clear();
    conductors_.clear();
    if (auto const* const column = store.findColumn<Conductor>()) {
        conductors_.assign(column->owners().begin(), column->owners().end());
    }
    std::vector<std::optional<PlacedConductor>> placed;
    placed.reserve(conductors_.size());
    for (ObjectId const id : conductors_) {
        placed.push_back(placedConductorOf(store, id));
    }
    auto const* const connections = store.findColumn<ElectricityGraph>();
    SwitchedLinks const switched(world);
    for (std::size_t a = 0; a < conductors_.size(); ++a) {
        ElectricityGraph const* const row =
            connections == nullptr ? nullptr : connections->find(conductors_[a]);
        for (std::size_t b = a + 1; b < conductors_.size(); ++b) {
            ObjectId const other = conductors_[b];
            bool const connected =
                row != nullptr && std::any_of(row->connections.begin(), row->connections.end(),
                                              [&](auto const& connection) { return connection.to == other; });
            if (connected) {
                links_.push_back({a, b, {.a = conductors_[a], .b = other}});
                continue;
            }
            if (auto const link = switched.between(conductors_[a], other)) {
                links_.push_back({a, b, *link});
            }
            if (CircuitGap cut{.a = conductors_[a], .b = other, .cost = cutCost, .reason = GapReason::cut};
                wires_.contains({cut.a, cut.b}) && !switched.addBlown(cut)) {
                links_.push_back({a, b, std::move(cut)});
                continue;
            }
            if (!placed[a] || !placed[b] || leastDistance(*placed[a], *placed[b]) > widest) {
                continue;
            }
            ShapeGap const gap = gapBetween(placed[a]->placed, placed[b]->placed);
            if (gap.width <= widest) {
                CircuitGap made{.a = conductors_[a], .b = other};
                made.width = std::max(gap.width, leastGapCost);
                made.cost = made.width + (isContact(store, conductors_[a], other) ? 0 : widest);
                made.from = gap.a;
                made.to = gap.b;
                switched.addBlown(made);
                links_.push_back({a, b, std::move(made)});
            }
        }
    }
}

CircuitCut CircuitSight::cutIn(World const& world, std::size_t object, std::string const& network,
                               bool onePath) const {
    Store const& store = world.store();
    auto const isOf = [&](ObjectId id) {
        Conductor const* const conductor = entryOf<Conductor>(store, id);
        return conductor != nullptr && (conductor->network.empty() || conductor->network == network);
    };
    TwoPaths paths(conductors_.size());
    for (std::size_t i = 0; i < conductors_.size(); ++i) {
        ElectricalSource const* const source = entryOf<ElectricalSource>(store, conductors_[i]);
        ElectricalReturn const* const back = entryOf<ElectricalReturn>(store, conductors_[i]);
        if (source != nullptr && source->network == network) {
            paths.endsAt(i, TwoPaths::End::first);
        }
        if (back != nullptr && back->network == network) {
            paths.endsAt(i, TwoPaths::End::second);
        }
    }
    for (std::size_t i = 0; i < links_.size(); ++i) {
        Link const& link = links_[i];
        if (isOf(conductors_[link.a]) && isOf(conductors_[link.b])) {
            paths.link(link.a, link.b, link.gap.cost, i);
        }
    }
    CircuitCut cut;
    auto const found = isOf(conductors_[object]) ? paths.from(object, onePath) : std::nullopt;
    cut.hopeless = !found.has_value();
    if (found) {
        for (std::size_t const used : *found) {
            if (links_[used].gap.cost > 0) {
                cut.gaps.push_back(links_[used].gap);
                if (areEndsOfOther(store, cut.gaps.back(), network)) {
                    cut.gaps.back().reason = GapReason::foreign;
                }
                cut.width += links_[used].gap.reason == GapReason::apart ? links_[used].gap.width : 0;
                cut.cost += links_[used].gap.cost;
            }
        }
        std::sort(cut.gaps.begin(), cut.gaps.end(), [](CircuitGap const& x, CircuitGap const& y) {
            return std::pair(x.a, x.b) < std::pair(y.a, y.b);
        });
    }
    return cut;
}

CircuitCut const& CircuitSight::cutAt(World const& world, ObjectId object) {
    look(world);
    auto const [at, isNew] = cuts_.try_emplace(object);
    if (!isNew) {
        return at->second;
    }
    CircuitCut best;
    best.hopeless = true;
    auto const place = std::lower_bound(conductors_.begin(), conductors_.end(), object);
    if (place != conductors_.end() && *place == object) {
        auto const* const returns = world.store().findColumn<ElectricalReturn>();
        bool const onePath = returns == nullptr || neverHadReturns(*returns);
        for (std::string const& network : networksOf(world.store())) {
            CircuitCut cut =
                cutIn(world, static_cast<std::size_t>(place - conductors_.begin()), network, onePath);
            if (!cut.hopeless && (best.hopeless || cut.cost < best.cost)) {
                best = std::move(cut);
            }
        }
    }
    at->second = std::move(best);
    return at->second;
}

} // namespace trembler::insight
