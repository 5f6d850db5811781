#include "runtime/level/model/detail_levels.hpp"

#include <algorithm>

namespace trembler {

std::map<std::string, std::vector<std::string>> detailLevels(Registry const& registry) {
    std::map<std::string, std::vector<std::string>> all;
    for (Registration const& registration : registry.components()) {
        ComponentText const& text = registration.info->text;
        if (text.level.empty()) {
            continue;
        }
        auto& levels = all[std::string(text.effect)];
        if (std::find(levels.begin(), levels.end(), text.level) == levels.end()) {
            levels.emplace_back(text.level);
        }
    }
    return all;
}

} // namespace trembler
