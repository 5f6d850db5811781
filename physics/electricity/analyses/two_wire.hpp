// Electricity's detail level two-wire (A.6): objects on a path from source to return are on.
#pragma once

#include "physics/electricity/core/state_update.hpp"
#include "physics/electricity/core/sufficient_level.hpp"
#include "runtime/component/dps.hpp"

namespace trembler {

/// Marks every vertex that has two paths, one to the source and one to the return of a network, with only the
/// vertex itself in common: exactly the vertices in the block (maximal 2-connected subgraph) of the virtual
/// edge between source and return (A.6.1, proof in A.6.3; blocks after Tarjan 1972, by the Boost Graph
/// Library). O(v + e) for a circuit of one network; for a circuit of several, O(n log n) in all, with
/// n = v + e.
///
/// Source and return are separate nodes to which the objects are joined, so that any number of objects can be
/// sources, a wire directly from a source to a return is treated like others, and a battery is on only while
/// its circuit is closed.
void markTwoWire(Circuit const& circuit, std::vector<std::uint8_t>& on);

class TwoWireElectricity final
    : public Dps<TwoWireElectricity,
                 Reads<ElectricityGraph, GraphChanges, Conductor, ElectricalSource, ElectricalReturn>,
                 Derives<ElectricalState, ElectricalQuantities>> {
public:
    static constexpr ComponentText text{.name = "Two-wire Electricity",
                                        .effect = "electricity",
                                        .level = "two-wire",
                                        .work =
                                            "An object is on while it lies on a path from the source to the "
                                            "return of a network that it may take part in; the path uses no "
                                            "object twice. Analyses only circuits that have changed.",
                                        .rank = 2};
    using Activation = NeedsAny<Conductor>;
    using LeavesEmpty = ElectricalQuantities;
    static constexpr Coverage memory =
        leftOut("the analyses of unchanged circuits; recomputed, they give the same results");
    /// If no object has a resistance, an EMF, a rating or a fuse.
    static bool suits(Store const& store);
    static bool faithful(Store const& store);
    static std::string why(Store const& store) { return whyElectricalLevel(store); }
    void update(Access& access) { updateElectricalState(access, update_, markTwoWire); }

private:
    StateUpdate update_;
};

} // namespace trembler
