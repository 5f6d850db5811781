#include "physics/electricity/analyses/kept_analyses.hpp"

#include <algorithm>

namespace trembler {

NodalSolution const& KeptAnalyses::solve(Netlist const& netlist, std::string_view network) {
    if (nodes_ > nodesKept) {
        kept_.clear();
        nodes_ = 0;
    }
    ObjectId const first = netlist.objects.empty() ? ObjectId{} : netlist.objects.front();
    std::vector<NodalAnalysis>& known = kept_[{first, std::string(network)}];
    auto at = std::find_if(known.begin(), known.end(),
                           [&](NodalAnalysis const& analysis) { return analysis.sameStructure(netlist); });
    if (at == known.end()) {
        if (known.size() < structuresKept) {
            known.emplace_back();
            at = known.end() - 1;
            nodes_ += netlist.objects.size();
        } else {
            at = known.begin(); // the least recently used one
        }
    }
    std::rotate(at, at + 1, known.end());
    return known.back().solve(netlist);
}

int KeptAnalyses::symbolicFactorisations() const {
    int sum = 0;
    for (auto const& [key, known] : kept_) {
        for (NodalAnalysis const& analysis : known) {
            sum += analysis.symbolicFactorisations();
        }
    }
    return sum;
}

int KeptAnalyses::numericFactorisations() const {
    int sum = 0;
    for (auto const& [key, known] : kept_) {
        for (NodalAnalysis const& analysis : known) {
            sum += analysis.numericFactorisations();
        }
    }
    return sum;
}

} // namespace trembler
