// Exports circuits as a SPICE netlist for other programs.
#pragma once

#include <string>
#include <string_view>

namespace trembler {

class Store;

/// A netlist of every circuit of the world that is computed by nodal analysis, as it is connected now, for
/// `ngspice -b`, which then prints all potentials and the currents of the sources. Comments state the objects
/// of a node ("* n3 = 'middle', 'dead end'"; ideal conductors that touch are one node), the object of an
/// element ("* v1: source 'plus'"), and the objects of a connection with its callers ("* r1: 'coil' to
/// 'lamp', by level", "* 'bar' to 'plus', by Electricity <- Dynamics" within one node). Node 0 is the return
/// of every network. Floating islands, which SPICE cannot compute, are left out, and named in a comment.
/// Empty if there is no such circuit. Throws nothing.
[[nodiscard]] std::string spiceNetlist(Store const& store, std::string_view title);

} // namespace trembler
