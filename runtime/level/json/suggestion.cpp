#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace trembler {

std::size_t editDistance(std::string_view a, std::string_view b, std::size_t limit) {
    // A common beginning and end are left out of the computation: the words of a file often differ in a
    // number only.
    while (!a.empty() && !b.empty() && a.front() == b.front()) {
        a.remove_prefix(1);
        b.remove_prefix(1);
    }
    while (!a.empty() && !b.empty() && a.back() == b.back()) {
        a.remove_suffix(1);
        b.remove_suffix(1);
    }
    // Kept, because a file may ask for the distances of very many words.
    thread_local std::vector<std::size_t> beforeLast;
    thread_local std::vector<std::size_t> last;
    thread_local std::vector<std::size_t> row;
    for (auto* const line : {&beforeLast, &last, &row}) {
        line->resize(b.size() + 1);
    }
    std::iota(last.begin(), last.end(), std::size_t{0});
    std::size_t leastOfLast = 0;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            std::size_t const change = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
            }
        }
        // A row follows from the two before it, by steps that do not make it smaller.
        std::size_t const least = *std::min_element(row.begin(), row.end());
        if (least >= limit && leastOfLast >= limit) {
            return limit;
        }
        leastOfLast = least;
        std::swap(beforeLast, last);
        std::swap(last, row);
    }
    return std::min(last[b.size()], limit);
}

std::optional<std::string> suggestion(std::string_view word, std::span<std::string const> known) {
    constexpr std::size_t longest = 100; // a longer word is not a typing error
    if (word.size() > longest) {
        return std::nullopt;
    }
    std::size_t best = std::max<std::size_t>(1, word.size() / 3) + 1;
    std::optional<std::string> found;
    for (std::string const& candidate : known) {
        std::size_t const difference =
            candidate.size() > word.size() ? candidate.size() - word.size() : word.size() - candidate.size();
        if (difference >= best) {
            continue;
        }
        if (std::size_t const distance = editDistance(word, candidate, best); distance < best) {
            best = distance;
            found = candidate;
        }
    }
    return found;
}

std::string didYouMean(std::string_view word, std::span<std::string const> known) {
    auto const near = suggestion(word, known);
    return near ? fmt::format(" (did you mean '{}'?)", *near) : std::string();
}

std::string listed(std::span<std::string const> words) {
    constexpr std::size_t most = 30;
    std::string all;
    for (std::size_t i = 0; i < std::min(words.size(), most); ++i) {
        if (i > 0) {
            all += i + 1 == words.size() ? " or " : ", ";
        }
        all += fmt::format("'{}'", words[i]);
    }
    if (words.size() > most) {
        all += ", ...";
    }
    return all;
}

} // namespace trembler
