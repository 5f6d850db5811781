// The analyses of circuits seen lately, kept so that one that comes back need not be factorised again.
#pragma once

#include "physics/electricity/analyses/nodal_analysis.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace trembler {

/// A circuit that is opened and closed again and again, as in a doorbell, has a few structures that
/// alternate. Of every circuit, known by its first object and network, the latest few are kept. Keeping them
/// saves time and changes no result: NodalAnalysis depends on nothing but the netlist.
class KeptAnalyses {
public:
    static constexpr std::size_t structuresKept = 3;
    static constexpr std::size_t nodesKept =
        300'000; ///< over all, about a kilobyte each; beyond, all is forgotten

    NodalSolution const& solve(Netlist const& netlist, std::string_view network);

    [[nodiscard]] int symbolicFactorisations() const;
    [[nodiscard]] int numericFactorisations() const;

private:
    using Key = std::pair<ObjectId, std::string>;
    std::map<Key, std::vector<NodalAnalysis>> kept_; // of each: the latest used last
    std::size_t nodes_ = 0;
};

} // namespace trembler
