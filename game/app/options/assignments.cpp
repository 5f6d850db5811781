#include "game/app/commands.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace trembler {

std::pair<std::string, std::string> assignment(std::string const& text, char const* option,
                                               char const* form) {
    std::size_t const at = text.rfind('=');
    if (at == std::string::npos || at == 0 || at + 1 == text.size()) {
        throw std::invalid_argument(fmt::format("{} {}: expected {}", option, text, form));
    }
    return {text.substr(0, at), text.substr(at + 1)};
}

std::map<std::string, std::string> detailOf(std::vector<std::string> const& options) {
    std::map<std::string, std::string> detail;
    for (std::string const& text : options) {
        auto const [effect, level] = assignment(text, "--detail", "EFFECT=LEVEL");
        detail[effect] = level;
    }
    return detail;
}

} // namespace trembler
