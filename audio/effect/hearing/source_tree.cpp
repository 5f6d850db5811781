#include "audio/effect/hearing/source_tree.hpp"

#include <algorithm>
#include <numeric>

namespace trembler {

SourceTree::SourceTree(std::span<SoundSource const> sources) : sources_(sources), order_(sources.size()) {
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    if (!order_.empty()) {
        halve(0, static_cast<std::uint32_t>(order_.size()));
    }
}

void SourceTree::halve(std::uint32_t first, std::uint32_t last) {
    constexpr std::uint32_t few = 8;
    SoundSource const& one = sources_[order_[first]];
    Group group{{one.at, one.at}, one.loudness, one.frequency, first, last, 0};
    for (std::uint32_t const member : membersOf(group)) {
        SoundSource const& source = sources_[member];
        group.bounds.include({source.at, source.at});
        group.loudest = std::max(group.loudest, source.loudness);
        group.lowestFrequency = std::min(group.lowestFrequency, source.frequency);
    }
    std::size_t const here = groups_.size();
    groups_.push_back(group);
    if (group.size() <= few) {
        return;
    }
    Vec2 const extent = group.bounds.upper - group.bounds.lower;
    auto const along = [&](std::uint32_t source) {
        return extent.x >= extent.y ? sources_[source].at.x : sources_[source].at.y;
    };
    std::uint32_t const middle = first + group.size() / 2;
    std::nth_element(
        order_.begin() + first, order_.begin() + middle, order_.begin() + last,
        [&](std::uint32_t a, std::uint32_t b) { return along(a) != along(b) ? along(a) < along(b) : a < b; });
    halve(first, middle);
    groups_[here].second = static_cast<std::uint32_t>(groups_.size());
    halve(middle, last);
}

} // namespace trembler
