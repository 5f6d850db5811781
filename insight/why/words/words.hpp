// Answers in words and as JSON.
#pragma once

#include "insight/why/words/clauses.hpp"
#include "insight/why/words/miss_words.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace trembler::insight {

/// The answer as sentences. `goal` is the text of the goal that was asked about, if it was one.
[[nodiscard]] std::vector<std::string> sentencesOf(Answer const& answer, std::string const& goal,
                                                   AnswerLanguage const& language);
/// How the answer is known and from how many runs: "confirmed in 9 runs".
[[nodiscard]] std::string sourceOf(Answer const& answer, AnswerLanguage const& language);
/// The object that `trembler why --json` prints; other programs rely on its keys. `asked` is the question in
/// words.
[[nodiscard]] nlohmann::ordered_json toJson(Answer const& answer, std::string const& asked,
                                            std::string const& goal, AnswerLanguage const& language);

} // namespace trembler::insight
