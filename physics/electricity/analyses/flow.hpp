// Electricity's detail level flow (7.3.2): how much current a network lets through, and where its bottleneck
// is.
#pragma once

#include "physics/electricity/analyses/max_flow.hpp"
#include "physics/electricity/core/quantities_update.hpp"
#include "physics/electricity/core/state_update.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "runtime/component/dps.hpp"

#include <array>

namespace trembler {

/// An object is on as with two-wire, where one whose capacity is 0 does not conduct. Beyond that it finds,
/// for each circuit, the largest current from source to return and the objects that let no more through. It
/// knows nothing of volts and ohms, so a balanced bridge's lamp is on to it, as to two-wire; a fuse is a
/// capacity, and never melts. It costs more than two-wire and finds less than nodal, so no scene calls for
/// it: it is there to be asked for.
class FlowElectricity final : public Dps<FlowElectricity,
                                         Reads<ElectricityGraph, GraphChanges, Conductor, ElectricalSource,
                                               ElectricalReturn, CurrentCapacity, Fuse>,
                                         Derives<ElectricalState, ElectricalQuantities>> {
public:
    static constexpr ComponentText text{
        .name = "Flow Electricity",
        .effect = "electricity",
        .level = "flow",
        .work = "Computes the largest current that can flow from the source to the return of each network "
                "through objects of limited capacity, and which objects are its bottleneck. An object is on "
                "while it lies on a path from source to return. Looks only at circuits that have changed.",
        .rank = 4};
    using Activation = NeedsAny<Conductor>;
    static constexpr Coverage memory =
        leftOut("the analyses of circuits that have not changed; recomputed, they come to the same");
    static bool suits(Store const&) { return false; } // of itself
    /// Capacities count for it alone, and its fuses never melt.
    static bool faithful(Store const& store) { return isFaithful(ElectricalLevel::flow, store); }
    static std::string why(Store const& store) { return whyElectricalLevel(store); }
    void update(Access& access);

private:
    struct Limit {
        ObjectId object;
        Microamperes most = unlimited;
        friend bool operator==(Limit const&, Limit const&) = default;
    };
    void findChangedLimits(Column<CurrentCapacity> const& capacities, Column<Fuse> const& fuses);
    [[nodiscard]] Microamperes limitOf(ObjectId object) const;
    void analyse(Circuit const& circuit, std::vector<std::uint8_t>& on);

    StateUpdate update_;
    std::vector<Limit> limits_; // ascending
    std::array<std::uint64_t, 2> seen_{};
    std::vector<ObjectId> changed_;
    std::vector<CircuitQuantities> found_; // by number of the circuit
};

} // namespace trembler
