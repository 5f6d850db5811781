// Electricity's detail level flow (7.3.2): the greatest current of a network, and its bottleneck.
#pragma once

#include "physics/electricity/analyses/max_flow.hpp"
#include "physics/electricity/core/quantities_update.hpp"
#include "physics/electricity/core/state_update.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "runtime/component/dps.hpp"

#include <array>

namespace trembler {

/// Objects are on as with two-wire, except that objects of capacity 0 do not conduct. In addition it finds,
/// for each circuit, the largest current from source to return and the objects that limit it. It ignores
/// volts and ohms, so the lamp in a balanced bridge is on, as with two-wire; a fuse is a capacity, and never
/// melts. It costs more than two-wire and finds less than nodal, so it is used only on request.
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
                "while it lies on a path from source to return. Analyses only circuits that have changed.",
        .rank = 4};
    using Activation = NeedsAny<Conductor>;
    static constexpr Coverage memory =
        leftOut("the analyses of unchanged circuits; recomputed, they give the same results");
    static bool suits(Store const&) { return false; } // only on request
    /// Only this level uses capacities, and its fuses never melt.
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
