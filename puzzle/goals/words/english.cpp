#include "puzzle/goals/words/english.hpp"

#include <array>
#include <cctype>
#include <string_view>

namespace trembler {
namespace {

bool isUpper(char c) {
    return c >= 'A' && c <= 'Z';
}
bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isVowel(char c) {
    return std::string_view("aeiouAEIOU").find(c) != std::string_view::npos;
}

} // namespace

std::string withArticle(std::string const& name) {
    bool const own = name.empty() || isUpper(name[0]) || isDigit(name.back()) || name.starts_with("the ");
    return own ? name : "the " + name;
}

std::string withIndefiniteArticle(std::string const& noun) {
    return (!noun.empty() && isVowel(noun[0]) ? "an " : "a ") + noun;
}

std::string pluralOf(std::string const& noun) {
    if (noun.empty() || std::isalpha(static_cast<unsigned char>(noun.back())) == 0) {
        return noun; // "battery +"
    }
    auto const endsWith = [&](std::string_view end) { return noun.ends_with(end); };
    if (endsWith("s") || endsWith("x") || endsWith("ch") || endsWith("sh")) {
        return noun + "es";
    }
    if (endsWith("y") && noun.size() > 1 && !isVowel(noun[noun.size() - 2])) {
        return noun.substr(0, noun.size() - 1) + "ies";
    }
    return noun + "s";
}

std::string numberWord(int number) {
    constexpr std::array<std::string_view, 13> words{"no",   "one",    "two",   "three", "four",
                                                     "five", "six",    "seven", "eight", "nine",
                                                     "ten",  "eleven", "twelve"};
    return number >= 0 && number < static_cast<int>(words.size())
               ? std::string(words[static_cast<std::size_t>(number)])
               : std::to_string(number);
}

std::string enumerated(std::vector<std::string> const& items, std::string const& last) {
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) {
            text += i + 1 == items.size() ? " " + last + " " : ", ";
        }
        text += items[i];
    }
    return text;
}

std::string capitalised(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    }
    return text;
}

std::string asClause(std::string text) {
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) {
        text.pop_back();
    }
    if (text.size() > 1 && isUpper(text[0]) && !isUpper(text[1])) { // not "LED ..."
        text[0] = static_cast<char>(text[0] - 'A' + 'a');
    }
    return text;
}

} // namespace trembler
