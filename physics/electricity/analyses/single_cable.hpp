// Electricity's cheap detail level, single-cable (A.4): objects that are connected to a source are on.
#pragma once

#include "physics/electricity/core/state_update.hpp"
#include "physics/electricity/core/sufficient_level.hpp"
#include "runtime/component/dps.hpp"

namespace trembler {

/// Marks every vertex that is connected to a source of a network in which it may take part. O(v + e) for a
/// circuit of one network; for a circuit of several, O(n log n) in all, with n = v + e.
void markSingleCable(Circuit const& circuit, std::vector<std::uint8_t>& on);

class SingleCableElectricity final
    : public Dps<SingleCableElectricity,
                 Reads<ElectricityGraph, GraphChanges, Conductor, ElectricalSource, ElectricalReturn>,
                 Derives<ElectricalState, ElectricalQuantities>> {
public:
    static constexpr ComponentText text{
        .name = "Single-cable Electricity",
        .effect = "electricity",
        .level = "single-cable",
        .work = "An object is on while it is connected to a source of a network that "
                "it may take part in. Analyses only circuits that have changed.",
        .rank = 1};
    using Activation = NeedsAny<Conductor>;
    using LeavesEmpty = ElectricalQuantities;
    static constexpr Coverage memory =
        leftOut("the analyses of unchanged circuits; recomputed, they give the same results");
    /// In worlds that never had a return; see neverHadReturns().
    static bool suits(Store const& store);
    static bool faithful(Store const& store);
    static std::string why(Store const& store) { return whyElectricalLevel(store); }
    void update(Access& access) { updateElectricalState(access, update_, markSingleCable); }

private:
    StateUpdate update_;
};

} // namespace trembler
