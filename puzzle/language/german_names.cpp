#include "puzzle/language/german_names.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace trembler {
namespace {

bool isNumber(std::string_view word) {
    return !word.empty() &&
           std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Of a list of pieces: "domino a".
bool isLetter(std::string_view word) {
    return word.size() == 1 && ((word[0] >= 'a' && word[0] <= 'z') || (word[0] >= 'A' && word[0] <= 'Z'));
}

std::string definiteArticle(std::string const& article, GermanCase use) {
    if (use == GermanCase::accusative && article == "der") {
        return "den";
    }
    if (use == GermanCase::dative) {
        return article == "die" ? "der" : "dem";
    }
    return article;
}

std::string indefiniteArticle(std::string const& article, GermanCase use) {
    bool const feminine = article == "die";
    switch (use) {
    case GermanCase::accusative:
        return feminine ? "eine" : article == "der" ? "einen" : "ein";
    case GermanCase::dative:
        return feminine ? "einer" : "einem";
    case GermanCase::nominative:
        break;
    }
    return feminine ? "eine" : "ein";
}

/// Of an adjective behind the definite article.
std::string_view weakEnding(std::string const& article, GermanCase use) {
    bool const n = use == GermanCase::dative || (use == GermanCase::accusative && article == "der");
    return n ? "en" : "e";
}

/// Of an adjective without an article, or, but for the dative, behind the indefinite one.
std::string_view strongEnding(std::string const& article, GermanCase use) {
    if (use == GermanCase::dative) {
        return article == "die" ? "er" : "em";
    }
    if (use == GermanCase::nominative) {
        return article == "der" ? "er" : article == "das" ? "es" : "e";
    }
    return use == GermanCase::accusative && article == "das" ? "es" : weakEnding(article, use);
}

std::map<std::string, std::string, std::less<>> wordsIn(nlohmann::json const& file, char const* section) {
    std::map<std::string, std::string, std::less<>> words;
    if (auto const found = file.find(section); found != file.end() && found->is_object()) {
        for (auto const& [english, german] : found->items()) {
            if (german.is_string()) {
                words[english] = german.get<std::string>();
            }
        }
    }
    return words;
}

} // namespace

GermanNames::GermanNames(nlohmann::json const& file) {
    if (!file.is_object()) {
        return;
    }
    for (auto const& [english, german] : wordsIn(file, "nouns")) {
        std::size_t const space = german.find(' ');
        std::size_t const bar = german.find('|');
        if (space == std::string::npos) {
            continue;
        }
        std::size_t const second = bar == std::string::npos ? bar : german.find('|', bar + 1);
        nouns_[english] = {german.substr(0, space), german.substr(space + 1, bar - space - 1),
                           bar == std::string::npos ? std::string()
                                                    : german.substr(bar + 1, second - bar - 1),
                           second == std::string::npos ? std::string() : german.substr(second + 1)};
    }
    adjectives_ = wordsIn(file, "adjectives");
    behind_ = wordsIn(file, "behind");
}

std::optional<GermanNames::Parsed> GermanNames::parsed(std::string_view name) const {
    if (auto const noun = nouns_.find(name); noun != nouns_.end()) {
        return Parsed{{}, noun->second, {}, false};
    }
    constexpr auto mostBlanks =
        6; // the ways to divide a name grow exponentially, and levels may name things at length
    if (std::count(name.begin(), name.end(), ' ') > mostBlanks) {
        return std::nullopt;
    }
    std::size_t const last = name.rfind(' ');
    if (last == std::string_view::npos) {
        return std::nullopt;
    }
    std::string_view const ending = name.substr(last + 1);
    auto const behind = behind_.find(ending);
    if (bool const counted = isNumber(ending) || isLetter(ending); counted || behind != behind_.end()) {
        if (auto rest = parsed(name.substr(0, last))) {
            rest->behind += " " + (counted ? std::string(ending) : behind->second);
            rest->numbered = rest->numbered || counted;
            return rest;
        }
    }
    std::size_t const first = name.find(' ');
    // A number ends the name of a part, with its adjectives: "short wire 1 left end".
    for (std::size_t at = first; at != std::string_view::npos; at = name.find(' ', at + 1)) {
        std::string_view const before = name.substr(0, at);
        auto piece =
            isNumber(before.substr(before.rfind(' ') + 1)) ? parsed(name.substr(at + 1)) : std::nullopt;
        if (piece && understands(std::string(before))) {
            piece->behind += " (" + bare(std::string(before)) + ")";
            return piece;
        }
    }
    if (auto const adjective = adjectives_.find(name.substr(0, first)); adjective != adjectives_.end()) {
        if (auto rest = parsed(name.substr(first + 1))) {
            rest->adjectives.insert(rest->adjectives.begin(), adjective->second);
            return rest;
        }
    }
    // A piece of a part, which is named for the part: of the ways to divide the name, that with the longest
    // piece.
    for (std::size_t at = first; at != std::string_view::npos; at = name.find(' ', at + 1)) {
        auto const whole = parsed(name.substr(0, at));
        auto piece = parsed(name.substr(at + 1));
        if (whole && piece) {
            piece->behind += " (" + whole->noun.word + whole->behind + ")";
            return piece;
        }
    }
    return std::nullopt;
}

std::string GermanNames::bare(std::string const& name) const {
    auto const found = parsed(name);
    if (!found) {
        return name;
    }
    std::string text;
    for (std::string const& stem : found->adjectives) {
        text += stem + std::string(strongEnding(found->noun.article, GermanCase::nominative)) + " ";
    }
    return text + found->noun.word + found->behind;
}

std::string GermanNames::definite(std::string const& name, GermanCase use) const {
    auto const found = parsed(name);
    if (!found) {
        return name;
    }
    std::string text = found->numbered ? "" : definiteArticle(found->noun.article, use) + " ";
    for (std::string const& stem : found->adjectives) {
        auto const ending =
            found->numbered ? strongEnding(found->noun.article, use) : weakEnding(found->noun.article, use);
        text += stem + std::string(ending) + " ";
    }
    bool const alone = found->numbered && found->adjectives.empty(); // "durch Magnet 2"
    return text + (alone ? found->noun.word : found->noun.in(use)) + found->behind;
}

std::string GermanNames::indefinite(std::string const& name, GermanCase use) const {
    auto const found = parsed(name);
    if (!found) {
        return name;
    }
    std::string text = indefiniteArticle(found->noun.article, use) + " ";
    for (std::string const& stem : found->adjectives) {
        bool const dative = use == GermanCase::dative;
        text += stem + std::string(dative ? "en" : strongEnding(found->noun.article, use)) + " ";
    }
    return text + found->noun.in(use) + found->behind;
}

std::string GermanNames::plural(std::string const& name, GermanCase use) const {
    auto const found = parsed(name);
    if (!found) {
        return name;
    }
    std::string text = found->noun.plural.empty() ? found->noun.word : found->noun.plural;
    bool const ends = text.ends_with('n') || text.ends_with('s');
    return use == GermanCase::dative && !found->noun.plural.empty() && !ends ? text + "n" : text;
}

} // namespace trembler
