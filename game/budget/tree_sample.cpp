#include "game/budget/tree_sample.hpp"

#include "physics/dynamics/properties/body.hpp"

#include <cmath>
#include <set>

namespace trembler::budget {

void TreeSample::add(inverse_square::Points const& sources, inverse_square::Points const& receivers,
                     bool ownElsewhere, double softening2) {
    if (sources.empty() || receivers.empty()) {
        return;
    }
    Sum sum;
    sum.receivers = receivers.size();
    sum.softening2 = softening2;
    sum.tree.build(sources);
    sum.tree.setReceivers(receivers, ownElsewhere);
    constexpr std::size_t size = inverse_square::Tree::groupSize;
    std::size_t const all = (receivers.size() + size - 1) / size;
    std::size_t const count = std::min(all, groups);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t const begin = (2 * i + 1) * all / (2 * count) * size;
        sum.ranges.emplace_back(begin, std::min(begin + size, receivers.size()));
    }
    // The tree orders its receivers: the receivers in these groups are the ones whose totals are not zero.
    std::vector<Vec2> totals(receivers.size());
    for (auto const& [begin, end] : sum.ranges) {
        sum.tree.add(begin, end, 1, softening2, totals);
    }
    auto const* const masses = world_.store().findColumn<Mass>();
    auto const* const fixed = world_.store().findColumn<Fixed>();
    inverse_square::Points held;
    for (std::size_t row = 0; row < totals.size(); ++row) {
        auto const owner = static_cast<std::uint32_t>(receivers.owner[row]);
        ObjectId const id = world_.store().objects().at(owner);
        Mass const* const mass = masses == nullptr ? nullptr : masses->find(id);
        if (!(totals[row] == Vec2{}) && mass != nullptr && (fixed == nullptr || !fixed->has(id))) {
            sum.looked.push_back({row, owner, mass->value, {}});
            held.add(receivers.at(row), receivers.weight[row], receivers.owner[row]);
        }
    }
    std::vector<Vec2> right(held.size());
    inverse_square::addAllPairs(sources, held, 0, held.size(), softening2, right);
    for (std::size_t i = 0; i < right.size(); ++i) {
        sum.looked[i].right = right[i];
    }
    sums_.push_back(std::move(sum));
}

Error TreeSample::errorAt(double openingAngle) const {
    double off = 0;
    double wrong = 0;
    double all = 0;
    std::set<std::uint32_t> bodies;
    for (Sum const& sum : sums_) {
        std::vector<Vec2> totals(sum.receivers);
        for (auto const& [begin, end] : sum.ranges) {
            sum.tree.add(begin, end, openingAngle, sum.softening2, totals);
        }
        for (Sum::Looked const& looked : sum.looked) {
            double const square = lengthSquared(totals[looked.row] - looked.right);
            off += square / (4 * looked.mass * looked.mass);
            wrong += square;
            all += lengthSquared(looked.right);
            bodies.insert(looked.owner);
        }
    }
    return {bodies.empty() ? 0 : std::sqrt(off / static_cast<double>(bodies.size())),
            all > 0 ? std::sqrt(wrong / all) : 0};
}

} // namespace trembler::budget
