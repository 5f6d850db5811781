#include "puzzle/edit/commands/solutions.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "puzzle/session/renaming.hpp"
#include "runtime/level/build/placing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

namespace trembler::edit {
namespace {

constexpr char const* placementsKey = "placements";
std::array<std::string, 4> const listKeys{placementsKey, "wires", "inputs", "changes"};

void mustBeList(std::string const& list) {
    if (std::find(listKeys.begin(), listKeys.end(), list) == listKeys.end()) {
        throw CommandError(fmt::format("a recorded solution has no list '{}'", list));
    }
}

void mustBeEntry(Json const& entry) {
    if (!entry.is_object() && !entry.is_array()) {
        throw CommandError("an entry of a recorded solution is an object or a pair of names");
    }
}

/// The list of a solution; nullptr if it has none.
Json const* listOf(Json const& level, std::string const& solution, std::string const& list) {
    Json const& entry = level["solutions"][indexOfSolution(level, solution)];
    auto const found = entry.find(list);
    return found == entry.end() || !found->is_array() ? nullptr : &*found;
}

void mustHaveListEntry(Json const& level, std::string const& solution, std::string const& list,
                       std::size_t index) {
    mustBeList(list);
    Json const* const entries = listOf(level, solution, list);
    if (entries == nullptr || index >= entries->size()) {
        throw CommandError(fmt::format("there is no such entry of the solution '{}'", solution));
    }
}

std::vector<std::string> namesOfPlaced(Json const& level, Json const& solution) {
    auto const found = solution.is_object() ? solution.find(placementsKey) : solution.end();
    if (!solution.is_object() || found == solution.end() || !found->is_array()) {
        return {};
    }
    std::vector<Placement> placements;
    for (Json const& entry : *found) {
        Placement placement;
        placement.part = textOf(entry, "part");
        placement.at = placeOf(entry);
        placement.angle = angleOf(entry);
        auto const flipped = entry.is_object() ? entry.find("flipped") : entry.end();
        placement.flipped = entry.is_object() && flipped != entry.end() && *flipped == true;
        placements.push_back(std::move(placement));
    }
    std::vector<std::string> names = namesAsStated(placements, placementNames(takenNames(level), placements));
    for (std::size_t i = 0; i < names.size(); ++i) {
        names[i] = placements[i].part.empty() ? std::string() : names[i];
    }
    return names;
}

/// Renames what an entry refers to. Returns false if it refers to something that is gone.
bool followNames(Json& value, Renaming const& renaming) {
    if (value.is_string()) {
        auto const now = renaming.newName(value.get<std::string>());
        if (now && now->empty()) {
            return false;
        }
        if (now) {
            value = *now;
        }
    } else if (value.is_array() || value.is_object()) {
        for (Json& inner : value) {
            if (!followNames(inner, renaming)) {
                return false;
            }
        }
    }
    return true;
}

/// Changes the placements, and then the wires and inputs that name their objects. `goneIndex` is that of the
/// placement that the change removes.
void changePlacements(Json& level, Json& solution, std::function<void(Json&)> const& change,
                      std::optional<std::size_t> goneIndex = {}, std::vector<std::size_t> const& order = {}) {
    std::vector<std::string> const before = namesOfPlaced(level, solution);
    change(solution[placementsKey]);
    std::vector<std::string> const now = namesOfPlaced(level, solution);
    Renaming renaming(takenNames(level));
    for (std::size_t i = 0; i < before.size(); ++i) {
        std::size_t const shifted = goneIndex && i > *goneIndex ? i - 1 : i;
        std::size_t const to = i < order.size() ? order[i] : shifted;
        std::string const name = goneIndex == i || to >= now.size() ? std::string() : now[to];
        if (!before[i].empty()) {
            renaming.add(before[i], name);
        }
    }
    if (renaming.empty()) {
        return;
    }
    for (char const* const key : {"wires", "inputs"}) {
        auto const list = solution.find(key);
        if (list == solution.end() || !list->is_array()) {
            continue;
        }
        Json kept = Json::array();
        for (Json& entry : *list) {
            if (followNames(entry, renaming)) {
                kept.push_back(std::move(entry));
            }
        }
        if (kept.empty()) {
            solution.erase(key);
        } else {
            *list = std::move(kept);
        }
    }
}

Json& entryOfSolution(Json& tree, std::string const& solution) {
    return tree["solutions"][indexOfSolution(tree, solution)];
}

} // namespace

Command addSolutionEntry(Json const& level, std::string const& solution, std::string const& list,
                         Json const& entry) {
    mustBeList(list);
    mustBeEntry(entry);
    static_cast<void>(indexOfSolution(level, solution));
    return {fmt::format("Add to solution '{}'", solution), [=](Json& tree) {
                Json& recorded = entryOfSolution(tree, solution);
                auto const found = recorded.find(list);
                Json entries = found == recorded.end() ? Json::array() : *found;
                if (!entries.is_array()) {
                    throw CommandError(fmt::format("'{}' is no list", list));
                }
                setMember(recorded, list, std::move(entries), solutionOrder());
                auto const add = [&](Json& all) { all.push_back(entry); };
                if (list == placementsKey) {
                    changePlacements(tree, recorded, add);
                } else {
                    add(recorded[list]);
                }
            }};
}

Command setSolutionEntry(Json const& level, std::string const& solution, std::string const& list,
                         std::size_t index, Json const& entry) {
    mustHaveListEntry(level, solution, list, index);
    mustBeEntry(entry);
    return {fmt::format("Change solution '{}'", solution), [=](Json& tree) {
                mustHaveListEntry(tree, solution, list, index);
                Json& recorded = entryOfSolution(tree, solution);
                auto const set = [&](Json& all) { all[index] = entry; };
                if (list == placementsKey) {
                    changePlacements(tree, recorded, set);
                } else {
                    set(recorded[list]);
                }
            }};
}

Command removeSolutionEntry(Json const& level, std::string const& solution, std::string const& list,
                            std::size_t index) {
    mustHaveListEntry(level, solution, list, index);
    return {fmt::format("Remove from solution '{}'", solution), [=](Json& tree) {
                mustHaveListEntry(tree, solution, list, index);
                Json& recorded = entryOfSolution(tree, solution);
                auto const remove = [&](Json& all) { all.erase(index); };
                if (list == placementsKey) {
                    changePlacements(tree, recorded, remove, index);
                } else {
                    remove(recorded[list]);
                }
                if (recorded[list].empty()) {
                    recorded.erase(list);
                }
            }};
}

Command moveSolutionEntry(Json const& level, std::string const& solution, std::string const& list,
                          std::size_t from, std::size_t to) {
    mustHaveListEntry(level, solution, list, from);
    mustHaveListEntry(level, solution, list, to);
    return {fmt::format("Order solution '{}'", solution), [=](Json& tree) {
                mustHaveListEntry(tree, solution, list, from);
                mustHaveListEntry(tree, solution, list, to);
                Json& recorded = entryOfSolution(tree, solution);
                std::vector<std::size_t> order(recorded[list].size()); // where each entry comes to be
                for (std::size_t i = 0; i < order.size(); ++i) {
                    order[i] = i == from ? to : i > from && i <= to ? i - 1 : i < from && i >= to ? i + 1 : i;
                }
                auto const move = [&](Json& all) {
                    Json const entry = all[from];
                    all.erase(from);
                    all.insert(all.begin() + static_cast<std::ptrdiff_t>(to), entry);
                };
                if (list == placementsKey) {
                    changePlacements(tree, recorded, move, {}, order); // equal ones are numbered in order
                } else {
                    move(recorded[list]);
                }
            }};
}

std::vector<std::string> placedNames(Json const& level, std::string const& solution) {
    return namesOfPlaced(level, level["solutions"][indexOfSolution(level, solution)]);
}

} // namespace trembler::edit
