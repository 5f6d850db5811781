#include "puzzle/language/speech.hpp"

#include "puzzle/goals/words/english.hpp"
#include "puzzle/language/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace trembler {
namespace {

std::string filledWith(std::string_view text, std::initializer_list<Noun> nouns) {
    Catalogue::Pieces const pieces = Catalogue::piecesOf(text);
    std::string filled = pieces.between.front();
    auto noun = nouns.begin();
    for (std::size_t i = 0; i < pieces.gaps.size(); ++i) {
        if (noun != nouns.end()) {
            filled += pieces.gaps[i] == "dat" && !noun->dative.empty() ? noun->dative : noun->words;
            ++noun;
        }
        filled += pieces.between[i + 1];
    }
    return filled;
}

/// "im Korb" for "in dem Korb".
std::string contracted(std::string text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> shorter{{{" in dem ", " im "},
                                                                                    {" in das ", " ins "},
                                                                                    {" zu dem ", " zum "},
                                                                                    {" zu der ", " zur "},
                                                                                    {" von dem ", " vom "}}};
    for (auto const& [full, brief] : shorter) {
        for (std::size_t at = text.find(full); at != std::string::npos; at = text.find(full, at)) {
            text.replace(at, full.size(), brief);
        }
    }
    return text;
}

std::string wordsOf(Noun const& noun, bool dative) {
    return dative && !noun.dative.empty() ? noun.dative : noun.words;
}

std::string listed(std::vector<Noun> const& items, std::string const& last, bool dative) {
    std::vector<std::string> words;
    std::transform(items.begin(), items.end(), std::back_inserter(words),
                   [&](Noun const& item) { return wordsOf(item, dative); });
    return enumerated(words, last);
}

} // namespace

std::string Speech::phrase(std::string_view english, std::initializer_list<Noun> nouns) const {
    return filledWith(english, nouns);
}

Noun Speech::the(std::string const& name) const {
    return {withArticle(name)};
}

Noun Speech::area(std::string const& called) const {
    return {called};
}

Noun Speech::a(std::string const& part) const {
    return {withIndefiniteArticle(part)};
}

Noun Speech::all(std::string const& part) const {
    return {"the " + pluralOf(part), true};
}

Noun Speech::some(std::string const& prefix, int number, std::string const& part) const {
    bool const plural = number != 1;
    return {prefix + numberWord(number) + " " + (plural ? pluralOf(part) : part), plural};
}

Noun Speech::someOf(std::string const& prefix, int number, std::vector<Noun> const& items) const {
    return {prefix + (number == 0 ? "none" : numberWord(number)) + " of " + list(items, "and").words,
            number != 1};
}

Noun Speech::everyOne(std::vector<Noun> const& items) const {
    Noun all = list(items, "and");
    all.words = (items.size() == 1 ? "" : items.size() == 2 ? "both " : "all of ") + all.words;
    return all;
}

Noun Speech::list(std::vector<Noun> const& items, std::string const& last) const {
    return {listed(items, last, false), items.size() > 1};
}

std::string Speech::number(double value) const {
    return fmt::format("{}", value);
}

Speech const& englishSpeech() {
    static Speech const speech;
    return speech;
}

std::string GermanSpeech::phrase(std::string_view english, std::initializer_list<Noun> nouns) const {
    char const* const known = catalogue_.find(english);
    return contracted(filledWith(known == nullptr ? english : known, nouns));
}

Noun GermanSpeech::the(std::string const& name) const {
    return {catalogue_.names().definite(name, GermanCase::accusative), false,
            catalogue_.names().definite(name, GermanCase::dative)};
}

Noun GermanSpeech::area(std::string const& called) const {
    constexpr std::string_view article = "the ";
    return called.starts_with(article) ? the(called.substr(article.size())) : the(called);
}

Noun GermanSpeech::a(std::string const& part) const {
    return {catalogue_.names().indefinite(part, GermanCase::accusative), false,
            catalogue_.names().indefinite(part, GermanCase::dative)};
}

Noun GermanSpeech::all(std::string const& part) const {
    return {"die " + catalogue_.names().plural(part, GermanCase::accusative), true,
            "den " + catalogue_.names().plural(part, GermanCase::dative)};
}

Noun GermanSpeech::some(std::string const& prefix, int number, std::string const& part) const {
    constexpr std::array<std::string_view, 13> words{
        "", "", "zwei", "drei", "vier", "fünf", "sechs", "sieben", "acht", "neun", "zehn", "elf", "zwölf"};
    std::string const before = phrase(prefix, {});
    if (number == 1) {
        Noun const one = a(part);
        return {before + one.words, false, before + one.dative};
    }
    GermanNames const& names = catalogue_.names();
    std::string const several = number < static_cast<int>(words.size())
                                    ? std::string(words[static_cast<std::size_t>(std::max(number, 0))])
                                    : std::to_string(number);
    return {before + (number == 0 ? "keine" : several) + " " + names.plural(part, GermanCase::accusative),
            true, before + (number == 0 ? "keinen" : several) + " " + names.plural(part, GermanCase::dative)};
}

Noun GermanSpeech::someOf(std::string const& prefix, int number, std::vector<Noun> const& items) const {
    std::string const many = number == 0 ? "nichts" : number == 1 ? "eins" : std::to_string(number);
    std::string const words = phrase(prefix, {}) + many + " von " + list(items, "and").dative;
    return {words, number != 1, words};
}

Noun GermanSpeech::everyOne(std::vector<Noun> const& items) const {
    return list(items, "and"); // "die Lampe und die Glocke" says it
}

Noun GermanSpeech::list(std::vector<Noun> const& items, std::string const& last) const {
    std::string const word = phrase(last, {});
    return {listed(items, word, false), items.size() > 1, listed(items, word, true)};
}

std::string GermanSpeech::number(double value) const {
    std::string text = fmt::format("{}", value);
    std::replace(text.begin(), text.end(), '.', ',');
    return text;
}

} // namespace trembler
