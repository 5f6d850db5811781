#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {

std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> beforeLast(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) {
        last[j] = j;
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            std::size_t const change = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
            }
        }
        std::swap(beforeLast, last);
        std::swap(last, row);
    }
    return last[b.size()];
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
        if (std::size_t const distance = editDistance(word, candidate); distance < best) {
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
