#include "insight/kind/kind_difference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace trembler::insight {
namespace {

template <class T>
std::vector<T> onlyIn(std::set<T> const& these, std::set<T> const& others) {
    std::vector<T> only;
    std::set_difference(these.begin(), these.end(), others.begin(), others.end(), std::back_inserter(only));
    return only;
}

GraphSide sideOf(CauseGraph const& these, CauseGraph const& others) {
    return {onlyIn(these.parts, others.parts), onlyIn(these.deeds, others.deeds),
            onlyIn(these.links, others.links)};
}

} // namespace

KindDifference differenceOf(CauseGraph const& here, CauseGraph const& there) {
    return {sideOf(here, there), sideOf(there, here)};
}

std::string inWords(GraphSide const& side) {
    std::vector<std::string> means = side.parts;
    means.insert(means.end(), side.deeds.begin(), side.deeds.end());
    std::vector<std::string> links;
    for (auto const& [cause, effect] : side.links) {
        links.push_back(cause + " leads to " + effect);
    }
    std::string words = fmt::format("{}", fmt::join(means, " + "));
    if (!means.empty() && !links.empty()) {
        words += "; ";
    }
    return words + fmt::format("{}", fmt::join(links, ", "));
}

} // namespace trembler::insight
