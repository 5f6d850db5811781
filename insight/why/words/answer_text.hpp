// An answer as one line of text, for journals.
#pragma once

#include "insight/why/answer.hpp"

#include <string>

namespace trembler::insight {

/// The answer about something that happened: the chain, and the facts about the objects that sentences need.
/// Not a nearest miss.
[[nodiscard]] std::string toText(Answer const& answer);
/// The inverse. The text must be one that toText() has made.
[[nodiscard]] Answer answerFrom(std::string const& text);

} // namespace trembler::insight
