#include "puzzle/solutions/solution_file.hpp"

#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/refuse_file.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/level/model/change_fault.hpp"
#include "runtime/level/read/solutions/check_inputs.hpp"
#include "runtime/level/read/solutions/read_solutions.hpp"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <vector>

namespace trembler {

Solution loadSolution(Registry const& registry, LevelFile const& level, std::filesystem::path const& file) {
    auto const document = JsonDocument::load(file);
    Problems problems;
    std::optional<Solution> solution = readSolution(JsonNode(*document, document->root(), "", problems));
    problems.throwIfAny();
    if (!solution) {
        return {};
    }
    solution->document = document;
    InputCheck(level).check(*solution, *document, problems);
    for (RecordedChange const& change : solution->changes) {
        if (auto const fault = faultIn(registry, change)) {
            addProblem(problems,
                       [&] { return document->diagnostic(change.path, fault->message, fault->expected); });
        }
    }
    problems.throwIfAny();
    return *solution;
}

Solution findOrLoadSolution(Registry const& registry, LevelFile const& level, std::string const& nameOrFile) {
    if (Solution const* const known = level.findSolution(nameOrFile)) {
        return *known;
    }
    std::error_code error;
    if (!std::filesystem::exists(nameOrFile, error)) {
        if (error) { // it may be there
            refuseFile(nameOrFile, fmt::format("cannot be read: {}", error.message()), "");
        }
        std::vector<std::string> names;
        for (Solution const& solution : level.solutions) {
            names.push_back(solution.name);
        }
        throw std::invalid_argument(fmt::format(
            "there is neither a file nor a recorded solution of this name{}; the level's solutions are: {}",
            didYouMean(nameOrFile, names), names.empty() ? "none" : listed(names)));
    }
    return loadSolution(registry, level, nameOrFile);
}

} // namespace trembler
