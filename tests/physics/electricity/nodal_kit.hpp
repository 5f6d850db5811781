// Circuits in volts and ohms for tests, and a reference that solves netlists by another method.
#pragma once

#include "physics/electricity/core/netlist.hpp"
#include "physics/electricity/properties/quantities.hpp"
#include "tests/physics/electricity/circuit_world.hpp"

#include <optional>
#include <string>
#include <vector>

namespace trembler::test {

/// A CircuitWorld whose objects can be resistors, batteries, lamps and fuses.
class NodalWorld : public CircuitWorld {
public:
    explicit NodalWorld(std::string const& level = {}, int threads = 1, bool trace = false);

    ObjectId resistor(std::string const& name, double ohm);
    ObjectId lamp(std::string const& name, double volt, double watt);
    ObjectId fuse(std::string const& name, double ampere);
    ObjectId battery(std::string const& name, double volt, double internalOhm = 0,
                     std::string const& network = {});
    /// Starts the world and computes one frame.
    void begin();

    [[nodiscard]] ElectricalQuantities const& quantities();
    [[nodiscard]] ElectricalQuantities::Entry at(std::string const& name);
    [[nodiscard]] ElectricalQuantities::Circuit circuitOf(std::string const& name);
    [[nodiscard]] std::vector<std::string> events();
};

/// The solution of a netlist by the whole tableau of Kirchhoff's laws, with every potential and every current
/// as an unknown, in long double with complete pivoting: no symmetry, no contraction, no sparsity. Ideal
/// branches have `idealOhm`. Undetermined values, such as the potential of an island, are 0.
struct Tableau {
    std::vector<long double> potentials; ///< by node
    std::vector<long double> currents;   ///< by branch
};
[[nodiscard]] Tableau solveTableau(Netlist const& netlist, long double idealOhm);

/// The netlist without the ideal branches that close a loop of ideal branches: they change no potential.
[[nodiscard]] Netlist withoutIdealLoops(Netlist const& netlist);

} // namespace trembler::test
