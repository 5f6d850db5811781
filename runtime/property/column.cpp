#include "runtime/property/column.hpp"

#include <algorithm>

namespace trembler {
namespace {

// SplitMix64's finaliser (Steele, Lea and Flood 2014): sums of well-mixed ids distinguish sets of owners.
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31U);
}

} // namespace

std::uint32_t ColumnBase::insertOwner(ObjectId id) {
    assert(id.valid() && !has(id));
    if (rows_.size() <= id.index) {
        rows_.resize(id.index + std::size_t{1}, absent);
    }
    auto const at = owners_.empty() || owners_.back() < id
                        ? owners_.end()
                        : std::lower_bound(owners_.begin(), owners_.end(), id);
    auto const row = static_cast<std::uint32_t>(at - owners_.begin());
    owners_.insert(at, id);
    for (std::size_t r = row; r < owners_.size(); ++r) {
        rows_[owners_[r].index] = static_cast<std::uint32_t>(r);
    }
    membership_ += mixed(packed(id));
    ++version_;
    ++structureVersion_;
    return row;
}

void ColumnBase::insertOwners(std::span<ObjectId const> ids) {
    if (ids.empty()) {
        return;
    }
    auto const before = static_cast<std::ptrdiff_t>(owners_.size());
    auto const firstMoved = static_cast<std::size_t>(
        std::lower_bound(owners_.begin(), owners_.end(), ids.front()) - owners_.begin());
    owners_.insert(owners_.end(), ids.begin(), ids.end());
    std::inplace_merge(owners_.begin(), owners_.begin() + before, owners_.end());
    if (rows_.size() <= owners_.back().index) {
        rows_.resize(owners_.back().index + std::size_t{1}, absent);
    }
    for (std::size_t r = firstMoved; r < owners_.size(); ++r) {
        rows_[owners_[r].index] = static_cast<std::uint32_t>(r);
    }
    for (ObjectId const id : ids) {
        membership_ += mixed(packed(id));
    }
    ++version_;
    ++structureVersion_;
}

void ColumnBase::eraseOwner(std::uint32_t row) {
    membership_ -= mixed(packed(owners_[row]));
    rows_[owners_[row].index] = absent;
    owners_.erase(owners_.begin() + row);
    for (std::size_t r = row; r < owners_.size(); ++r) {
        rows_[owners_[r].index] = static_cast<std::uint32_t>(r);
    }
    ++version_;
    ++structureVersion_;
}

std::vector<std::uint32_t> ColumnBase::eraseOwners(std::span<ObjectId const> ids) {
    std::vector<std::uint32_t> gone;
    for (ObjectId const id : ids) {
        if (std::uint32_t const r = row(id); r != absent) {
            gone.push_back(r);
        }
    }
    if (gone.empty()) {
        return {};
    }
    std::sort(gone.begin(), gone.end());
    gone.erase(std::unique(gone.begin(), gone.end()), gone.end());
    std::vector<std::uint32_t> kept;
    kept.reserve(owners_.size() - gone.size());
    std::size_t next = 0;
    for (std::uint32_t r = 0; r < owners_.size(); ++r) {
        if (next < gone.size() && gone[next] == r) {
            membership_ -= mixed(packed(owners_[r]));
            rows_[owners_[r].index] = absent;
            ++next;
        } else {
            rows_[owners_[r].index] = static_cast<std::uint32_t>(kept.size());
            owners_[kept.size()] = owners_[r];
            kept.push_back(r);
        }
    }
    owners_.resize(kept.size());
    ++version_;
    ++structureVersion_;
    return kept;
}

} // namespace trembler
