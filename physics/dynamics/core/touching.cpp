#include "physics/dynamics/core/touching.hpp"

#include <algorithm>
#include <cassert>
#include <compare>
#include <tuple>

namespace trembler {
namespace {

// The order of two pairs. Inline: called for each pair that touches, in each frame.
template <class X, class Y>
inline std::strong_ordering orderOf(X const& x, Y const& y) {
    return std::tie(x.a, x.b) <=> std::tie(y.a, y.b);
}

template <class X, class Y>
inline bool before(X const& x, Y const& y) {
    return orderOf(x, y) < 0;
}

} // namespace

void TouchBook::take(std::vector<TouchChange>& changes) {
    if (changes.empty()) {
        return;
    }
    assert(brief_.empty());
    std::sort(changes.begin(), changes.end(),
              [](TouchChange const& x, TouchChange const& y) { return before(x, y); });
    merged_.clear();
    auto count = counts_.cbegin();
    for (auto change = changes.cbegin(); change != changes.cend();) {
        while (count != counts_.cend() && before(*count, *change)) {
            merged_.push_back(*count++);
        }
        Count sum{change->a, change->b, 0};
        if (count != counts_.cend() && !before(*change, *count)) {
            sum.pieces = count++->pieces;
        }
        int const was = sum.pieces;
        for (; change != changes.cend() && !before(sum, *change); ++change) {
            sum.pieces += change->delta;
        }
        changed_ = changed_ || (was > 0) != (sum.pieces > 0);
        if (was == 0 && sum.pieces == 0) {
            brief_.push_back({sum.a, sum.b, {}});
            changed_ = true;
        }
        if (sum.pieces > 0) {
            merged_.push_back(sum);
        }
    }
    merged_.insert(merged_.end(), count, counts_.cend());
    counts_.swap(merged_);
    changes.clear();
}

void TouchBook::compare(Contacts const& before_, Contacts& next) const {
    next.current.resize(counts_.size());
    next.begun.clear();
    next.ended.clear();
    next.brief.clear();
    for (TouchingPair const& pair : brief_) {
        if (!std::binary_search(before_.current.begin(), before_.current.end(), pair)) {
            next.brief.push_back(pair);
        }
    }
    auto old = before_.current.cbegin();
    auto const end = before_.current.cend();
    auto current = next.current.begin();
    for (Count const& count : counts_) {
        std::strong_ordering order = std::strong_ordering::greater;
        for (; old != end && (order = orderOf(*old, count)) < 0; ++old) {
            next.ended.push_back({old->a, old->b, {}});
        }
        if (old != end && order == 0) {
            *current++ = *old++;
        } else {
            *current++ = {count.a, count.b, {}};
            next.begun.push_back({count.a, count.b, {}});
        }
    }
    for (; old != end; ++old) {
        next.ended.push_back({old->a, old->b, {}});
    }
}

} // namespace trembler
