// The lacks of a goal, in words and as JSON.
#pragma once

#include "insight/miss/miss.hpp"
#include "insight/why/words/clauses.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace trembler::insight {

/// How far a goal was from being met, as sentences: "The iron ball came within 4 cm of the electromagnet, at
/// 3.2 s."
[[nodiscard]] std::vector<std::string> sentencesOf(Miss const& miss, AnswerLanguage const& language);

/// The same for other programs, which rely on its keys.
[[nodiscard]] nlohmann::ordered_json toJson(Miss const& miss);

} // namespace trembler::insight
