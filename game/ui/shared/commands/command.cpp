#include "game/ui/shared/commands/command.hpp"

#include <stdexcept>
#include <string>

namespace trembler::ui {

bool CommandSet::has(std::string_view id) const {
    for (std::size_t i = 0; i < size(); ++i) {
        if (info(i).id == id) {
            return true;
        }
    }
    return false;
}

std::size_t CommandSet::indexOf(std::string_view id) const {
    for (std::size_t i = 0; i < size(); ++i) {
        if (info(i).id == id) {
            return i;
        }
    }
    throw std::invalid_argument("This screen has no command \"" + std::string(id) + "\".");
}

} // namespace trembler::ui
