// Circuits as other programs read them: a SPICE netlist.
#pragma once

#include <string>
#include <string_view>

namespace trembler {

class Store;

/// A netlist of every circuit of the world that is computed by nodal analysis, as it is connected now, for
/// `ngspice -b`, which then prints all potentials and the currents of the sources. Comments say which objects
/// a node is the middle of ("* n3 = 'middle', 'dead end'"; ideal conductors that touch are one node) to which
/// object an element belongs ("* v1: source 'plus'"), and which objects are connected, and by whom ("* r1:
/// 'coil' to 'lamp', by level", "* 'bar' to 'plus', by Electricity <- Dynamics" between two of one node).
/// Node 0 is the return of every network. Floating islands, which no SPICE can compute, are left out, and
/// named. Empty if there is no such circuit. Throws nothing.
[[nodiscard]] std::string spiceNetlist(Store const& store, std::string_view title);

} // namespace trembler
