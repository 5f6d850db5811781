#include "game/session/solution_file.hpp"

#include "runtime/level/read_solutions.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

namespace trembler {

Solution findOrLoadSolution(LevelFile const& level, std::string const& nameOrFile) {
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
    return solution.value_or(Solution{});
}

} // namespace trembler
