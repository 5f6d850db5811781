// Which objects are on by the two-wire rule, in a circuit of several networks.
#pragma once

#include "physics/electricity/core/circuit.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace trembler {

/// Sets `on` of the objects that lie on a path from source to return of one of these networks, which have
/// terminals of both kinds. A network's own part is joined to the forest of the plain conductors
/// (PlainForest) instead of the conductors themselves. So all networks together take O(n log n) for the n
/// vertices and connections of the circuit, however many networks share its conductors.
void markTwoWireNetworks(Circuit const& circuit, std::span<std::string_view const> networks,
                         std::vector<std::uint8_t>& on);

} // namespace trembler
