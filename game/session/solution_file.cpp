#include "game/session/solution_file.hpp"

#include "runtime/level/read_solutions.hpp"
#include "runtime/level/world_change.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

namespace trembler {

Solution findOrLoadSolution(Registry const& registry, LevelFile const& level, std::string const& nameOrFile) {
    if (Solution const* const known = level.findSolution(nameOrFile)) {
        return *known;
    }
    std::error_code error;
    if (!std::filesystem::exists(nameOrFile, error)) {
        std::string names;
        for (Solution const& solution : level.solutions) {
            names += (names.empty() ? "'" : ", '") + solution.name + "'";
        }
        throw std::invalid_argument(
            fmt::format("there is neither a file nor a recorded solution '{}'; the level's solutions are: {}",
                        nameOrFile, names.empty() ? "none" : names));
    }
    auto const document = JsonDocument::load(nameOrFile);
    Problems problems;
    std::optional<Solution> solution = readSolution(JsonNode(*document, document->root(), "", problems));
    problems.throwIfAny();
    if (solution && !solution->changes.empty()) {
        auto const faults = faultsIn(registry, solution->changes);
        for (std::size_t i = 0; i < faults.size(); ++i) {
            if (faults[i]) {
                problems.add(document->diagnostic(solution->changes[i].path, *faults[i], ""));
            }
        }
        problems.throwIfAny();
    }
    return solution.value_or(Solution{});
}

} // namespace trembler
