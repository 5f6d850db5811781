#include "game/app/options/run/solution_option.hpp"

#include "game/app/options/rule/rule.hpp"
#include "puzzle/checks/checked_level.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace trembler {

CLI::Option* addSolution(CLI::App& command, std::string& target, std::string const& meaning) {
    return accepts(command.add_option("--solution", target, meaning)->type_name("NAME|FILE"),
                   "the name of a solution that is recorded in the level, or a file with one");
}

Solution solutionStated(Registry const& registry, LevelFile const& level, std::string const& nameOrFile) {
    try {
        return findOrLoadSolution(registry, level, nameOrFile);
    } catch (std::invalid_argument const& error) {
        throw std::invalid_argument(fmt::format("--solution {}: {}", shown(nameOrFile), error.what()));
    }
}

std::unique_ptr<Session> sessionStated(GameData const& data, std::filesystem::path const& level,
                                       std::string const& nameOrFile) {
    auto session =
        std::make_unique<Session>(data.registry, data.parts, loadPlayable(data.registry, data.parts, level));
    if (!nameOrFile.empty()) {
        session->load(solutionStated(data.registry, session->level(), nameOrFile));
    }
    return session;
}

} // namespace trembler
