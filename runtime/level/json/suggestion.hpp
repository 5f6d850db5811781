// "Did you mean ...?": the known word that is nearest to an unknown one.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trembler {

/// The least number of insertions, deletions, changes and swaps of neighbours that turn one word into the
/// other (optimal string alignment distance), or `limit` if it is at least that. O(length × length), without
/// a common beginning and end, and O(length × limit) or less for words that differ from their beginning on.
[[nodiscard]] std::size_t editDistance(std::string_view a, std::string_view b,
                                       std::size_t limit = std::numeric_limits<std::size_t>::max());

/// The nearest of the known words, if it is so near that it may be the intended word; the first of equally
/// near ones.
[[nodiscard]] std::optional<std::string> suggestion(std::string_view word,
                                                    std::span<std::string const> known);

/// " (did you mean 'friction'?)" or nothing.
[[nodiscard]] std::string didYouMean(std::string_view word, std::span<std::string const> known);

/// "'a', 'b' or 'c'", shortened where there are very many.
[[nodiscard]] std::string listed(std::span<std::string const> words);

} // namespace trembler
