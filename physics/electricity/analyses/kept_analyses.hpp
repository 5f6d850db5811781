// A cache of the latest analyses of circuits, so that a structure that recurs need not be factorised again.
#pragma once

#include "physics/electricity/analyses/nodal_analysis.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace trembler {

/// A circuit that is opened and closed again and again, as in a doorbell, has a few structures that
/// alternate. For every circuit, identified by its first object and network, the latest few analyses are
/// kept. This saves time and changes no result: NodalAnalysis depends on the netlist alone.
class KeptAnalyses {
public:
    static constexpr std::size_t structuresKept = 3;
    static constexpr std::size_t nodesKept =
        300'000; ///< of all circuits, about a kilobyte each; with more, the cache is emptied

    NodalSolution const& solve(Netlist const& netlist, std::string_view network);

    [[nodiscard]] int symbolicFactorisations() const;
    [[nodiscard]] int numericFactorisations() const;

private:
    using Key = std::pair<ObjectId, std::string>;
    std::map<Key, std::vector<NodalAnalysis>> kept_; // for each, the most recently used last
    std::size_t nodes_ = 0;
};

} // namespace trembler
