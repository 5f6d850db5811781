#include "puzzle/edit/document/command.hpp"

#include <utility>

namespace trembler::edit {

Command together(std::string name, std::vector<Command> commands) {
    Command all{std::move(name), {}};
    for (Command const& command : commands) {
        if (!command.selects.empty()) {
            all.selects = command.selects;
        }
    }
    all.change = [commands = std::move(commands)](Json& level) {
        for (Command const& command : commands) {
            command.change(level);
        }
    };
    return all;
}

} // namespace trembler::edit
