// Circuits computed by somebody else, where that is installed.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace trembler::accuracy {

/// The potential, in V, of every object of a netlist of Trembler's (see spiceNetlist()), by name, as ngspice
/// has it. Nothing if there is no ngspice, or it does not understand the netlist. Starts a process and writes
/// a temporary file.
[[nodiscard]] std::optional<std::map<std::string, double>> potentialsByNgspice(std::string const& netlist);

} // namespace trembler::accuracy
