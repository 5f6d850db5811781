#include "insight/run/placed_names.hpp"

#include "runtime/level/build/placing.hpp"

#include <algorithm>

namespace trembler::insight {
namespace {

/// Whether `name` is that of an object or of one of its pieces.
bool belongsTo(std::string const& name, std::string const& object) {
    return name.starts_with(object) && (name.size() == object.size() || name[object.size()] == ' ');
}

/// The names of placements, by their index.
std::vector<std::string> namesByIndex(LevelFile const& level, std::span<Placement const> placements) {
    std::vector<std::string> const sorted = placementNames(level, placements);
    std::vector<std::size_t> const order = canonicalOrder(placements);
    std::vector<std::string> names(placements.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        names[order[i]] = sorted[i];
    }
    return names;
}

} // namespace

PlacedNames::PlacedNames(LevelFile const& level, std::span<Placement const> placements,
                         std::set<std::size_t> const& gone) {
    if (gone.empty()) {
        return;
    }
    std::vector<Placement> left;
    for (std::size_t i = 0; i < placements.size(); ++i) {
        if (!gone.contains(i)) {
            left.push_back(placements[i]);
        }
    }
    std::vector<std::string> const before = namesByIndex(level, placements);
    std::vector<std::string> const after = namesByIndex(level, left);
    std::size_t at = 0;
    for (std::size_t i = 0; i < placements.size(); ++i) {
        std::string const now = gone.contains(i) ? std::string() : after[at++];
        if (now != before[i]) {
            renamed_.emplace_back(before[i], now);
        }
    }
    for (LevelObject const& object : level.objects) {
        own_.insert(object.name);
    }
}

std::string PlacedNames::inReduced(std::string const& name) const {
    auto const one = std::find_if(renamed_.begin(), renamed_.end(),
                                  [&](Both const& both) { return belongsTo(name, both.first); });
    if (one == renamed_.end() || own_.contains(name)) {
        return name;
    }
    return one->second.empty() ? name + ", left out" : one->second + name.substr(one->first.size());
}

std::string PlacedNames::inWhole(std::string const& name) const {
    auto const one = std::find_if(renamed_.begin(), renamed_.end(), [&](Both const& both) {
        return !both.second.empty() && belongsTo(name, both.second);
    });
    return one == renamed_.end() || own_.contains(name) ? name : one->first + name.substr(one->second.size());
}

bool PlacedNames::isGone(std::string const& name) const {
    return !own_.contains(name) && std::any_of(renamed_.begin(), renamed_.end(), [&](Both const& both) {
        return both.second.empty() && belongsTo(name, both.first);
    });
}

} // namespace trembler::insight
