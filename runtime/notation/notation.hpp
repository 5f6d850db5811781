// Every component printed as the thesis's notation box, from the declarations that the schedule uses.
#pragma once

#include "runtime/world/registry.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace trembler {

/// The box of one component, as plain text.
[[nodiscard]] std::string notationBox(Registry const& registry, Registration const& component);
/// All boxes and the derived schedule, as plain text.
[[nodiscard]] std::string notationText(Registry const& registry);
/// The same as Markdown tables.
[[nodiscard]] std::string notationMarkdown(Registry const& registry);
/// The same as JSON: {"components": [...], "schedule": {...}}.
[[nodiscard]] nlohmann::ordered_json notationJson(Registry const& registry);

} // namespace trembler
