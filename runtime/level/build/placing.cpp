#include "runtime/level/build/placing.hpp"

#include "runtime/level/build/joint_names.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace trembler {
namespace {

/// Why `candidate` may not be placed in addition to `used` placements of the same part.
std::optional<std::string> check(LevelFile const& level, PartLibrary const& library, std::size_t used,
                                 Placement const& candidate) {
    if (library.find(candidate.part) == nullptr) {
        return fmt::format("There is no part '{}'{}.", candidate.part,
                           didYouMean(candidate.part, library.names()));
    }
    auto const tool = std::find_if(level.toolbox.begin(), level.toolbox.end(),
                                   [&](ToolboxEntry const& entry) { return entry.part == candidate.part; });
    if (tool == level.toolbox.end()) {
        return fmt::format("The toolbox of this level has no '{}'.", candidate.part);
    }
    if (tool->count < 1 || used >= static_cast<std::size_t>(tool->count)) {
        return tool->count == 1
                   ? fmt::format("The toolbox has only one '{}'.", candidate.part)
                   : fmt::format("The toolbox has only {} of '{}'.", tool->count, candidate.part);
    }
    if (!isFinite(candidate.at) || !std::isfinite(candidate.angle)) {
        return std::string("That is no place at all.");
    }
    if (level.placing) {
        bool const allowed = std::any_of(level.placing->begin(), level.placing->end(),
                                         [&](Area const& area) { return area.contains(candidate.at); });
        if (!allowed) {
            return std::string("Nothing can be placed there.");
        }
    } else if (level.bounds && !level.bounds->contains(candidate.at)) {
        return std::string("That is outside the level.");
    }
    return std::nullopt;
}

} // namespace

std::optional<std::string> checkPlacement(LevelFile const& level, PartLibrary const& library,
                                          std::span<Placement const> others, Placement const& candidate) {
    auto const used = std::count_if(others.begin(), others.end(),
                                    [&](Placement const& other) { return other.part == candidate.part; });
    return check(level, library, static_cast<std::size_t>(used), candidate);
}

PlacementCount::PlacementCount(LevelFile const& level, PartLibrary const& library)
    : level_(level), library_(library) {}

std::optional<std::string> PlacementCount::add(Placement const& candidate) {
    return check(level_, library_, used_[candidate.part]++, candidate);
}

std::vector<std::size_t> canonicalOrder(std::span<Placement const> placements) {
    std::vector<std::size_t> order(placements.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        Placement const& a = placements[i];
        Placement const& b = placements[j];
        return std::tie(a.part, a.at.x, a.at.y, a.angle, a.flipped) <
               std::tie(b.part, b.at.x, b.at.y, b.angle, b.flipped);
    });
    return order;
}

std::vector<Placement> inCanonicalOrder(std::span<Placement const> placements) {
    std::vector<Placement> sorted;
    sorted.reserve(placements.size());
    for (std::size_t const i : canonicalOrder(placements)) {
        sorted.push_back(placements[i]);
        sorted.back().at += Vec2{0, 0}; // makes -0 to 0, so that equal places have equal bits
        sorted.back().angle += 0.0;
    }
    return sorted;
}

std::vector<std::string> placementNames(LevelFile const& level, std::span<Placement const> placements) {
    if (placements.empty()) {
        return {};
    }
    std::vector<std::string> const joints = jointNames(level);
    std::set<std::string> taken(joints.begin(), joints.end());
    for (LevelObject const& object : level.objects) {
        taken.insert(object.name);
    }
    return placementNames(taken, placements);
}

std::vector<std::string> placementNames(std::set<std::string> const& taken,
                                        std::span<Placement const> placements) {
    std::vector<std::string> names;
    std::map<std::string, int> numbers;
    for (Placement const& placement : inCanonicalOrder(placements)) {
        std::string name;
        do {
            name = fmt::format("{} {}", placement.part, ++numbers[placement.part]);
        } while (taken.contains(name));
        names.push_back(std::move(name));
    }
    return names;
}

} // namespace trembler
