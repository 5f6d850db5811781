#include "puzzle/session/refused_solution.hpp"

#include <fmt/format.h>

namespace trembler {

InputError refusedSolution(LevelFile const& level, Solution const& solution,
                           std::function<bool(std::size_t)> const& builds, InputError const& error) {
    std::size_t built = 0; // with none of them the level is as its author made it
    std::size_t refused = solution.placements.size() + 1;
    while (refused - built > 1) {
        std::size_t const middle = built + (refused - built) / 2;
        (builds(middle) ? built : refused) = middle;
    }
    if (refused > solution.placements.size()) {
        return error;
    }
    Placement const& placement = solution.placements[refused - 1];
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    diagnostics.push_back(level.diagnostic(
        solution, placement.path, fmt::format("no world can be built with '{}' there", placement.part),
        "a placement that the rules of its objects allow"));
    return InputError(std::move(diagnostics));
}

} // namespace trembler
