// What levels call for as tables: for people, for programs, for the documentation.
#pragma once

#include "measure/activation/activation.hpp"

#include <nlohmann/json_fwd.hpp>

namespace trembler {

/// For a terminal: each play, and the components that are there.
[[nodiscard]] std::string activationText(std::vector<LevelUse> const& plays);
/// {"plays": [{"level", "title", "solution", "frames", "at_rest", "busiest_second", "last_second",
/// "components": [{"component", "state", "updates", "updates_in_last_second"}]}]}
[[nodiscard]] nlohmann::ordered_json activationJson(std::vector<LevelUse> const& plays);
/// docs/measurements/activation.md as a whole: every play in short, and the first one of each level by
/// component.
[[nodiscard]] std::string activationMarkdown(std::vector<LevelUse> const& plays);

} // namespace trembler
