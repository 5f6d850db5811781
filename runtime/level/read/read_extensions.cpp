#include "runtime/level/read/read_extensions.hpp"

#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {

std::vector<std::string> readExtensions(JsonNode const& node, Registry const& registry) {
    std::vector<std::string> names;
    if (!node.isList("a list of names of mods", mostExtensions)) {
        return names;
    }
    std::vector<std::string> const known(registry.extensions().begin(), registry.extensions().end());
    for (std::size_t i = 0; i < node.size(); ++i) {
        auto const name = node.element(i).name("the name of a mod");
        if (!name) {
            continue;
        }
        if (std::find(known.begin(), known.end(), *name) == known.end()) {
            node.element(i).complain(
                fmt::format("the mod '{}' is not loaded{}", *name, didYouMean(*name, known)),
                known.empty() ? "a mod that is installed" : listed(known));
        } else if (std::find(names.begin(), names.end(), *name) != names.end()) {
            node.element(i).complain(fmt::format("'{}' is repeated", *name), "every mod once");
        } else {
            names.push_back(*name);
        }
    }
    return names;
}

} // namespace trembler
