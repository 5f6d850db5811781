// English grammar for sentences about goals.
#pragma once

#include <string>
#include <vector>

namespace trembler {

/// "the lamp"; names such as "object 1" and "Bob" get no article.
[[nodiscard]] std::string withArticle(std::string const& name);
/// "a steel bar", "an iron ball".
[[nodiscard]] std::string withIndefiniteArticle(std::string const& noun);
/// "steel balls", "boxes", "batteries".
[[nodiscard]] std::string pluralOf(std::string const& noun);
/// "one" to "twelve", then digits; 0 is "no".
[[nodiscard]] std::string numberWord(int number);
/// "a, b and c", where `last` is the word before the last item, such as "and".
[[nodiscard]] std::string enumerated(std::vector<std::string> const& items, std::string const& last);
/// With a capital first letter.
[[nodiscard]] std::string capitalised(std::string text);
/// An author's sentence as a part of a longer one: without a full stop, and with a small first letter unless
/// it begins with an abbreviation.
[[nodiscard]] std::string asClause(std::string text);

} // namespace trembler
