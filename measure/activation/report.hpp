// The activation measurements as tables: text, JSON, and Markdown for the documentation.
#pragma once

#include "measure/activation/activation.hpp"

#include <nlohmann/json_fwd.hpp>

namespace trembler {

/// For a terminal: each play, and the constructed components.
[[nodiscard]] std::string activationText(std::vector<LevelUse> const& plays);
/// {"plays": [{"level", "title", "solution", "frames", "at_rest", "busiest_second", "last_second",
/// "components": [{"component", "state", "updates", "updates_in_last_second"}]}]}
[[nodiscard]] nlohmann::ordered_json activationJson(std::vector<LevelUse> const& plays);
/// The whole of docs/measurements/activation.md: a summary of every play, and the first play of each level by
/// component.
[[nodiscard]] std::string activationMarkdown(std::vector<LevelUse> const& plays);

} // namespace trembler
