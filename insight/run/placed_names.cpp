#include "insight/run/placed_names.hpp"

#include "runtime/level/build/placing.hpp"

#include <utility>
#include <vector>

namespace trembler::insight {
namespace {

/// The names of placements, by their index.
std::vector<std::string> namesByIndex(LevelFile const& level, std::span<Placement const> placements) {
    return namesAsStated(placements, placementNames(level, placements));
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
    std::set<std::string> own;
    for (LevelObject const& object : level.objects) {
        own.insert(object.name);
    }
    renamed_ = Renaming(std::move(own));
    std::vector<std::string> const before = namesByIndex(level, placements);
    std::vector<std::string> const after = namesByIndex(level, left);
    std::size_t at = 0;
    for (std::size_t i = 0; i < placements.size(); ++i) {
        renamed_.add(before[i], gone.contains(i) ? std::string() : after[at++]);
    }
}

std::string PlacedNames::inReduced(std::string const& name) const {
    auto const now = renamed_.newName(name);
    return !now ? name : now->empty() ? name + ", left out" : *now;
}

std::string PlacedNames::inWhole(std::string const& name) const {
    return renamed_.oldName(name).value_or(name);
}

bool PlacedNames::isGone(std::string const& name) const {
    return renamed_.newName(name) == std::string();
}

} // namespace trembler::insight
