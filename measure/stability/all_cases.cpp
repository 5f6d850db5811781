#include "measure/stability/hard_case.hpp"

#include <iterator>

namespace trembler::stability {

std::vector<HardCase> allCases() {
    std::vector<HardCase> all;
    for (auto const& some : {chainCases, stackCases, smallCases, impactCases, magnetCases, relayCases,
                             liquidCases, networkCases, orbitCases, machineCases}) {
        auto part = some();
        std::move(part.begin(), part.end(), std::back_inserter(all));
    }
    return all;
}

} // namespace trembler::stability
