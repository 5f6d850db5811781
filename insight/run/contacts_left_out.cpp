#include "insight/run/contacts_left_out.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>

namespace trembler::insight {
namespace {

constexpr std::int32_t allCategories = 0xffff;

CollisionGroups statedGroups(Store const& store, ObjectId id) {
    auto const* const column = store.findColumn<CollisionGroups>();
    CollisionGroups const* const stated = column == nullptr ? nullptr : column->find(id);
    return stated == nullptr ? CollisionGroups{} : *stated;
}

/// The objects that get a category of their own: one of each pair, and as few as a simple choice finds.
std::map<ObjectId, std::set<ObjectId>> chosenObjects(std::span<ObjectPair const> pairs) {
    std::map<ObjectId, std::set<ObjectId>> partners;
    for (auto const& [a, b] : pairs) {
        if (a != b) {
            partners[a].insert(b);
            partners[b].insert(a);
        }
    }
    std::map<ObjectId, std::set<ObjectId>> chosen;
    for (;;) {
        auto const most =
            std::max_element(partners.begin(), partners.end(),
                             [](auto const& x, auto const& y) { return x.second.size() < y.second.size(); });
        if (most == partners.end() || most->second.empty()) {
            return chosen;
        }
        ObjectId const object = most->first;
        std::set<ObjectId> const others = std::exchange(most->second, {});
        for (ObjectId const other : others) {
            partners[other].erase(object);
        }
        chosen.emplace(object, others);
    }
}

} // namespace

void leaveOutContacts(World& world, std::span<ObjectPair const> without) {
    Store& store = world.store();
    auto const* const shapes = store.findColumn<Shape>();
    if (shapes == nullptr || without.empty()) {
        return;
    }
    std::map<ObjectId, CollisionGroups> before;
    std::int32_t taken = 0;
    for (ObjectId const id : shapes->owners()) {
        CollisionGroups const groups = statedGroups(store, id);
        before.emplace(id, groups);
        taken |= groups.category;
    }
    std::map<ObjectId, CollisionGroups> after = before;
    std::map<ObjectId, std::set<ObjectId>> chosen = chosenObjects(without);
    std::erase_if(chosen, [&](auto const& one) { return !before.contains(one.first); }); // touches nothing
    for (auto const& [object, partners] : chosen) {
        std::int32_t own = 1;
        while ((own & taken) != 0 && own < allCategories) {
            own <<= 1;
        }
        if (own > allCategories) {
            throw std::invalid_argument("so many contacts cannot be left out at the same time");
        }
        taken |= own;
        // Whether it hits another object is decided by the mask of the other object alone, below.
        after[object] = {own, allCategories, 0};
    }
    for (auto const& [object, partners] : chosen) {
        std::int32_t const own = after[object].category;
        for (auto& [other, groups] : after) {
            bool const hits =
                other != object && canHit(before[object], before[other]) && !partners.contains(other);
            groups.mask = hits ? groups.mask | own : groups.mask & ~own;
        }
    }
    auto& column = store.column<CollisionGroups>();
    for (auto const& [id, groups] : after) {
        if (!(groups == before[id])) {
            column.set(id, groups);
        }
    }
}

} // namespace trembler::insight
