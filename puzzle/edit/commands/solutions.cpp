#include "puzzle/edit/commands/solutions.hpp"

#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/write/write_level.hpp"

#include <fmt/format.h>

namespace trembler::edit {
namespace {

constexpr char const* solutionsKey = "solutions";

std::set<std::string> solutionNames(Json const& level) {
    std::set<std::string> names;
    if (Json const* const list = findList(level, solutionsKey)) {
        for (Json const& solution : *list) {
            names.insert(textOf(solution, "name"));
        }
    }
    return names;
}

} // namespace

std::vector<std::string> const& solutionOrder() {
    static std::vector<std::string> const keys{"name",  "expect", "frames", "placements",
                                               "wires", "inputs", "changes"};
    return keys;
}

std::size_t indexOfSolution(Json const& level, std::string const& name) {
    if (Json const* const list = findList(level, solutionsKey)) {
        for (std::size_t i = 0; i < list->size(); ++i) {
            if (textOf((*list)[i], "name") == name) {
                return i;
            }
        }
    }
    throw CommandError(fmt::format("there is no recorded solution '{}'", name));
}

Command addSolution(Json const& level, Solution const& solution) {
    Solution named = solution;
    named.name = untaken(solutionNames(level), solution.name.empty() ? "solution" : solution.name);
    mustBeName(named.name, "the name of a solution");
    return {fmt::format("Record solution '{}'", named.name),
            [made = writeSolution(named)](Json& tree) { listIn(tree, solutionsKey).push_back(made); }};
}

Command recordAgain(Json const& level, std::string const& name, Solution const& solution) {
    static_cast<void>(indexOfSolution(level, name));
    return {fmt::format("Record solution '{}' again", name),
            [name, made = writeSolution(solution)](Json& tree) {
                Json& entry = tree[solutionsKey][indexOfSolution(tree, name)];
                for (char const* const key : {"frames", "placements", "wires", "inputs", "changes"}) {
                    if (auto const found = made.find(key); found != made.end()) {
                        setMember(entry, key, *found, solutionOrder());
                    } else {
                        entry.erase(key);
                    }
                }
            }};
}

Command renameSolution(Json const& level, std::string const& name, std::string const& to) {
    static_cast<void>(indexOfSolution(level, name));
    mustBeName(to, "the name of a solution");
    if (to != name && solutionNames(level).contains(to)) {
        throw CommandError(fmt::format("there is already a solution '{}'", to));
    }
    return {fmt::format("Rename solution to '{}'", to),
            [=](Json& tree) { tree[solutionsKey][indexOfSolution(tree, name)]["name"] = to; }};
}

Command removeSolution(Json const& level, std::string const& name) {
    static_cast<void>(indexOfSolution(level, name));
    return {fmt::format("Remove solution '{}'", name), [=](Json& tree) {
                std::size_t const index = indexOfSolution(tree, name);
                tree[solutionsKey].erase(index);
                dropIfEmpty(tree, solutionsKey);
            }};
}

Command expectSolved(Json const& level, std::string const& name, bool solved) {
    static_cast<void>(indexOfSolution(level, name));
    return {fmt::format("Expect '{}' {}", name, solved ? "to solve the level" : "not to solve the level"),
            [=](Json& tree) {
                Json& entry = tree[solutionsKey][indexOfSolution(tree, name)];
                if (solved) {
                    entry.erase("expect");
                } else {
                    setMember(entry, "expect", "unsolved", {"name", "expect"});
                }
            }};
}

Command setSolutionFrames(Json const& level, std::string const& name, int frames) {
    static_cast<void>(indexOfSolution(level, name));
    if (frames < 0 || frames > limits::frames) {
        throw CommandError(
            fmt::format("a run is stated to have 1 to {} frames, or 0: as long as it takes", limits::frames));
    }
    return {fmt::format("Change length of '{}'", name), [=](Json& tree) {
                Json& entry = tree[solutionsKey][indexOfSolution(tree, name)];
                if (frames == 0) {
                    entry.erase("frames");
                } else {
                    setMember(entry, "frames", frames, solutionOrder());
                }
            }};
}

Command moveSolution(Json const& level, std::size_t from, std::size_t to) {
    mustHaveEntry(level, solutionsKey, from, "solution");
    mustHaveEntry(level, solutionsKey, to, "solution");
    return {"Move solution", [=](Json& tree) { moveEntry(tree, solutionsKey, from, to); }};
}

} // namespace trembler::edit
