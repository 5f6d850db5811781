// Electricity's detail level nodal: direct current in volts, amperes and watts.
#pragma once

#include "physics/electricity/analyses/kept_analyses.hpp"
#include "physics/electricity/core/quantities_update.hpp"
#include "physics/electricity/core/state_update.hpp"
#include "physics/electricity/core/sufficient_level.hpp"
#include "runtime/component/dps.hpp"

#include <array>

namespace trembler {

/// Solves Kirchhoff's laws in every circuit that contains a resistance, an EMF, a rating or a fuse; objects
/// of other circuits are on or off as with the cheaper levels, as their currents are unknown. Networks are
/// solved one by one; an object in several networks carries the currents of all, and has the potential of the
/// first network by name in which it does not float.
///
/// An object is on while a current flows through it: at least `leastCurrent`, at least `leastShare` of the
/// largest in its network, and, if it has a rated power, enough for `leastPower` of that.
class NodalElectricity final : public Dps<NodalElectricity,
                                          Reads<ElectricityGraph, GraphChanges, Conductor, ElectricalSource,
                                                ElectricalReturn, Resistance, Emf, RatedPower, Fuse>,
                                          Derives<ElectricalState, ElectricalQuantities>> {
public:
    static constexpr ComponentText text{
        .name = "Nodal Electricity",
        .effect = "electricity",
        .level = "nodal",
        .work =
            "Computes potentials, currents and powers by Kirchhoff's laws. An object is on while a current "
            "flows through it; an object with a rated power, while its power is at least a hundredth of "
            "that. "
            "Reports short circuits and floating islands. Analyses only circuits that have changed; "
            "circuits without any resistance, EMF, rating or fuse are treated as two-wire or single-cable.",
        .rank = 3};
    static constexpr double leastCurrent = 1e-10; ///< A
    static constexpr double leastShare = 1e-9;
    static constexpr double leastPower = 0.01;
    using Activation = NeedsAny<Conductor>;
    static constexpr Coverage memory =
        leftOut("the analyses of unchanged circuits; recomputed, they give the same results");
    static std::string why(Store const& store) { return whyElectricalLevel(store); }
    void update(Access& access);

private:
    /// The stated values of an object at the last update.
    struct Part {
        ObjectId object;
        double resistance = 0;
        Emf emf;
        double ratedPower = 0;
        Fuse fuse;
        friend bool operator==(Part const&, Part const&) = default;
    };
    void findChangedParts(NodalColumns const& columns);
    void analyse(Circuit const& circuit, NodalColumns const& columns, Column<ElectricalReturn> const& returns,
                 std::vector<std::uint8_t>& on);
    void solve(Circuit const& circuit, NodalColumns const& columns, CircuitQuantities& found,
               std::vector<std::uint8_t>& on);

    StateUpdate update_;
    KeptAnalyses kept_;
    Netlist netlist_;
    std::vector<Part> parts_; // ascending
    std::array<std::uint64_t, 4> seen_{};
    std::vector<ObjectId> changed_;
    std::vector<CircuitQuantities> found_; // by number of the circuit
};

} // namespace trembler
