// The Electricity resolver (6.13.2): edits the electricity graph as instructed.
#pragma once

#include "physics/electricity/calls.hpp"
#include "physics/electricity/core/graph_changes.hpp"
#include "physics/electricity/core/held_connections.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "runtime/component/resolver.hpp"

#include <array>

namespace trembler {

/// Cheap: a derived property set finds which objects a change switches on or off. Besides calls, only the
/// creation and removal of objects and callers changes the graph; a frame without any of these costs O(1).
class ElectricityResolver final
    : public Resolver<ElectricityResolver, ElectricityRole,
                      Reads<Conductor, ElectricalSource, ElectricalReturn>,
                      Writes<ElectricityGraph, Fuse, Emf>, Provides<GraphChanges>> {
public:
    static constexpr ComponentText text{
        .name = "Electricity",
        .effect = "electricity",
        .level = "",
        .work = "Manipulates the electricity graph as instructed: counts, for each "
                "pair of conductors, the connections of each caller and of the "
                "level. Removes the connections of objects and callers that no longer exist. Blows fuses: a "
                "blown fuse has no connections. Adds induced voltages to the EMF of sources."};
    using Activation = NeedsAny<Conductor>;
    static constexpr Coverage memory =
        leftOut("the conductors and their networks in the last advance, to find changes");
    void hashMemory(StateHash& hash) const { held_.hash(hash); }
    void advance(Access& access);

private:
    /// The role of an object in the networks, unless it is a plain conductor.
    struct NetworkPart {
        enum class Kind : std::uint8_t { conductor, source, returning };
        ObjectId object;
        Kind kind = Kind::conductor;
        std::string network;
        friend auto operator<=>(NetworkPart const&, NetworkPart const&) = default;
    };
    struct Change {
        ObjectId a; ///< a < b
        ObjectId b;
        CallerId caller;
        int delta = 0;
        EventId event;
    };

    void followObjects(Access& access);
    void followVertices(Access& access);
    void followNetworks(Access& access);
    void followCallers(Access& access);
    void dropLooseEnds(Access& access);
    void blowFuses(Access& access);
    void induceVoltages(Access& access);
    void carryOutCalls(Access& access);
    void followHeld(Access& access);
    /// Whether the object takes connections.
    [[nodiscard]] static bool conducts(Access& access, ObjectId id);
    using VertexPair = std::pair<ObjectId, ObjectId>;
    /// Adds the pair to `removed` if it is no longer connected; its rows still contain it.
    void changePair(Access& access, std::span<Change const> changes, std::vector<VertexPair>& removed);
    void publish(Access& access);
    void touch(ObjectId object, EventId event = {}) { touched_.push_back({object, event, 0}); }

    std::vector<ObjectId> vertices_;      // as of the last advance, ascending
    std::vector<NetworkPart> parts_;      // as of the last advance, ascending
    std::vector<CallerId> callers_;       // as of the last advance, ascending
    std::array<std::uint64_t, 3> seen_{}; // versions of the columns read
    std::vector<GraphChanges::Touched> touched_;
    std::vector<Change> changes_;
    HeldConnections held_; // as of the last advance
    bool first_ = true;
};

} // namespace trembler
