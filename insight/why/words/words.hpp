// Answers in words and as JSON.
#pragma once

#include "insight/why/words/clauses.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace trembler::insight {

/// The answer as sentences. `goal` is the text of the goal that was asked about, if it was one.
[[nodiscard]] std::vector<std::string> sentencesOf(Answer const& answer, std::string const& goal,
                                                   AnswerLanguage const& language);
/// How far a goal was from being met, as sentences: "The iron ball came within 4 cm of the electromagnet, at
/// 3.2 s."
[[nodiscard]] std::vector<std::string> sentencesOf(Miss const& miss, AnswerLanguage const& language);

/// The object that `trembler why --json` prints; other programs rely on its keys. `asked` is the question in
/// words.
[[nodiscard]] nlohmann::ordered_json toJson(Answer const& answer, std::string const& asked,
                                            std::string const& goal, AnswerLanguage const& language);

} // namespace trembler::insight
