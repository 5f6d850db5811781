#include "physics/dynamics/engines/native/near_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trembler::native {
namespace {

constexpr std::int32_t noProxy = -1;
// The tree enlarges boxes by 0.1 of its units: 2 cm.
constexpr double unitsPerMetre = 5;

float below(double value) {
    auto const rounded = static_cast<float>(value * unitsPerMetre);
    return std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}
float above(double value) {
    auto const rounded = static_cast<float>(value * unitsPerMetre);
    return std::nextafter(rounded, std::numeric_limits<float>::infinity());
}
b2AABB treeBox(Bounds const& box) {
    b2AABB made;
    made.lowerBound = {below(box.low.x), below(box.low.y)};
    made.upperBound = {above(box.high.x), above(box.high.y)};
    return made;
}

void* userData(std::uint32_t name) {
    // Only the number is used. NOLINTNEXTLINE(performance-no-int-to-ptr)
    return reinterpret_cast<void*>(static_cast<std::uintptr_t>(name));
}
std::uint32_t nameIn(void const* data) {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(data));
}

template <class Visitor>
struct PairQuery {
    Visitor visit;
    bool QueryCallback(int32 proxy) { // NOLINT(readability-identifier-naming): Box2D calls it so
        visit(proxy);
        return true;
    }
};
template <class Visitor>
PairQuery(Visitor) -> PairQuery<Visitor>; // clang 14 has none for aggregates

} // namespace

Bounds boundsOf(Convex const& piece, Pose const& pose) {
    Vec2 const first = pose.place(piece.corners[0]);
    Bounds box{first, first};
    for (int i = 1; i < piece.count; ++i) {
        Vec2 const corner = pose.place(piece.corners[static_cast<std::size_t>(i)]);
        box.low = {std::min(box.low.x, corner.x), std::min(box.low.y, corner.y)};
        box.high = {std::max(box.high.x, corner.x), std::max(box.high.y, corner.y)};
    }
    Vec2 const round{piece.radius, piece.radius};
    return {box.low - round, box.high + round};
}

std::int32_t NearPairs::proxyOf(std::uint32_t name) const {
    return proxies_[slotOf(name)][pieceOf(name)];
}

void NearPairs::add(std::uint32_t name, Bounds const& box) {
    SlotIndex const slot = slotOf(name);
    if (proxies_.size() <= slot) {
        proxies_.resize(slot + std::size_t{1});
        movedMarks_.resize(slot + std::size_t{1}, 0);
    }
    if (proxies_[slot].size() <= pieceOf(name)) {
        proxies_[slot].resize(pieceOf(name) + std::size_t{1}, noProxy);
    }
    proxies_[slot][pieceOf(name)] = tree_.CreateProxy(treeBox(box), userData(name));
    moved_.push_back(name);
}

void NearPairs::remove(std::uint32_t name) {
    std::int32_t& proxy = proxies_[slotOf(name)][pieceOf(name)];
    tree_.DestroyProxy(proxy);
    proxy = noProxy;
    std::erase(moved_, name);
}

void NearPairs::move(std::uint32_t name, Bounds const& box) {
    if (tree_.MoveProxy(proxyOf(name), treeBox(box), b2Vec2_zero)) {
        moved_.push_back(name);
    }
}

void NearPairs::update(Filter const& mayTouch, std::vector<std::uint64_t>& gone,
                       std::vector<std::uint64_t>& come) {
    gone.clear();
    come.clear();
    if (moved_.empty()) {
        return;
    }
    for (std::uint32_t const name : moved_) {
        movedMarks_[slotOf(name)] = 1;
    }
    for (std::uint32_t const name : moved_) {
        PairQuery query{[&](int32 proxy) {
            std::uint32_t const other = nameIn(tree_.GetUserData(proxy));
            SlotIndex const a = std::min(slotOf(name), slotOf(other));
            SlotIndex const b = std::max(slotOf(name), slotOf(other));
            if (a != b && mayTouch(a, b)) {
                come.push_back(keyOf(name, other));
            }
        }};
        tree_.Query(&query, tree_.GetFatAABB(proxyOf(name)));
    }
    std::sort(come.begin(), come.end());
    come.erase(std::unique(come.begin(), come.end()), come.end());
    // `come` has every present pair of the moved pieces.
    merged_.clear();
    std::size_t kept = 0;
    auto next = come.cbegin();
    for (std::uint64_t const key : pairs_) {
        for (; next != come.cend() && *next < key; ++next) {
            merged_.push_back(*next);
            come[kept++] = *next;
        }
        if (next != come.cend() && *next == key) {
            ++next;
            merged_.push_back(key);
            continue;
        }
        bool const mayHaveParted =
            movedMarks_[slotOf(firstOf(key))] != 0 || movedMarks_[slotOf(secondOf(key))] != 0;
        if (mayHaveParted && !b2TestOverlap(tree_.GetFatAABB(proxyOf(firstOf(key))),
                                            tree_.GetFatAABB(proxyOf(secondOf(key))))) {
            gone.push_back(key);
        } else {
            merged_.push_back(key);
        }
    }
    for (; next != come.cend(); ++next) {
        merged_.push_back(*next);
        come[kept++] = *next;
    }
    come.resize(kept);
    pairs_.swap(merged_);
    for (std::uint32_t const name : moved_) {
        movedMarks_[slotOf(name)] = 0;
    }
    moved_.clear();
}

void NearPairs::forget(SlotIndex slot, std::vector<std::uint64_t>& gone) {
    gone.clear();
    std::erase_if(pairs_, [&](std::uint64_t key) {
        bool const goes = slotOf(firstOf(key)) == slot || slotOf(secondOf(key)) == slot;
        if (goes) {
            gone.push_back(key);
        }
        return goes;
    });
    if (slot >= proxies_.size()) {
        return;
    }
    for (std::size_t piece = 0; piece < proxies_[slot].size(); ++piece) {
        if (proxies_[slot][piece] != noProxy) {
            moved_.push_back(nameOf(slot, static_cast<std::uint32_t>(piece)));
        }
    }
}

} // namespace trembler::native
