// Every component printed as the thesis's notation box, from the declarations that the schedule uses.
#pragma once

#include "runtime/world/registry.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace trembler {

/// The box of one component, as plain text.
[[nodiscard]] std::string notationBox(Registry const& registry, Registration const& component);
/// The box of a completion, in the same form.
[[nodiscard]] std::string notationBox(CompletionInfo const& completion);
/// The box of a property (5.3).
[[nodiscard]] std::string notationBox(PropertyInfo const& property);
/// All boxes, the derived schedule and the coverage of the state hash, as plain text.
[[nodiscard]] std::string notationText(Registry const& registry);
/// The same as Markdown tables.
[[nodiscard]] std::string notationMarkdown(Registry const& registry);
/// The same as JSON: {"components": [...], "properties": [...], "completions": [...], "schedule": {...},
/// "state_hash": [...]}.
[[nodiscard]] nlohmann::ordered_json notationJson(Registry const& registry);

} // namespace trembler
