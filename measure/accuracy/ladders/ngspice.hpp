// Solves circuits with ngspice, as an independent reference, where it is installed.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace trembler::accuracy {

/// The potential in V of every object of a Trembler netlist (see spiceNetlist()), by the object's name,
/// computed by ngspice. nullopt if ngspice is not installed or does not accept the netlist. Starts a process
/// and writes a temporary file.
[[nodiscard]] std::optional<std::map<std::string, double>> potentialsByNgspice(std::string const& netlist);

} // namespace trembler::accuracy
