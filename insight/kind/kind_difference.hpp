// The difference between two kinds of solutions.
#pragma once

#include "insight/kind/cause_graph.hpp"

#include <string>
#include <vector>

namespace trembler::insight {

/// The parts, deeds and links that only one of two graphs has, in alphabetical order.
struct GraphSide {
    std::vector<std::string> parts;
    std::vector<std::string> deeds;
    std::vector<std::pair<std::string, std::string>> links; ///< (cause, effect), see CauseGraph

    [[nodiscard]] std::size_t size() const { return parts.size() + deeds.size() + links.size(); }
};

struct KindDifference {
    GraphSide here;
    GraphSide there;

    [[nodiscard]] std::size_t size() const { return here.size() + there.size(); }
};

/// The entries of `here` that `there` lacks, and the other way round.
[[nodiscard]] KindDifference differenceOf(CauseGraph const& here, CauseGraph const& there);

/// A side in words, for designers: "spanner; Dynamics leads to Electricity <- Dynamics"; empty if there is
/// nothing.
[[nodiscard]] std::string inWords(GraphSide const& side);

} // namespace trembler::insight
