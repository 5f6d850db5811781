#include "game/ui/shared/texts.hpp"

#include "game/ui/shared/catalogue_in_use.hpp"
#include "puzzle/data/game_data.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>
#include <map>
#include <memory>

namespace trembler::ui {
namespace {

constexpr std::array<Language, 2> knownLanguages{{{"en", "English"}, {"de", "Deutsch"}}};

/// Numbers as German writes them, without groups of three.
class DecimalComma final : public std::numpunct<char> {
protected:
    [[nodiscard]] char do_decimal_point() const override { return ','; }
};

struct TextsInUse {
    std::string_view language;
    Catalogue english;
    Catalogue texts;
    std::locale numbers;
    std::unique_ptr<Speech const> speech;          // nullptr: English
    std::map<std::string, std::string> translated; // as a list of problems is shown in every picture
};

struct Said {
    char const* english;
    char const* shown;
};

std::deque<Said>& constants() {
    static std::deque<Said> all; // a deque, as references to its elements are kept
    return all;
}

Language const* findLanguage(std::string_view id) {
    auto const found = std::find_if(knownLanguages.begin(), knownLanguages.end(),
                                    [&](Language const& language) { return language.id == id; });
    return found == knownLanguages.end() ? nullptr : &*found;
}

void load(TextsInUse& texts, std::string_view id) {
    Language const* const wanted = findLanguage(id);
    texts.language = wanted == nullptr ? languageOfDesktop() : wanted->id;
    auto const folder = homeFolder() / "assets" / "text";
    bool const german = texts.language == "de";
    texts.speech.reset();
    texts.translated.clear();
    texts.english = Catalogue(folder, "en");
    texts.texts = german ? Catalogue(folder, "de") : Catalogue();
    texts.numbers = german ? std::locale(std::locale::classic(), new DecimalComma) : std::locale::classic();
    if (german) {
        texts.speech = std::make_unique<GermanSpeech>(texts.texts);
    }
}

TextsInUse& inUse() {
    static TextsInUse texts = [] {
        TextsInUse english;
        load(english, "en");
        return english;
    }();
    return texts;
}

} // namespace

std::span<Language const> languages() {
    return knownLanguages;
}

std::string_view languageOfDesktop() {
    for (char const* const name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        char const* const value = std::getenv(name);
        if (value != nullptr && *value != '\0') {
            Language const* const known = findLanguage(std::string_view(value).substr(0, 2));
            return known == nullptr ? "en" : known->id;
        }
    }
    return "en";
}

void useLanguage(std::string_view id) {
    Language const* const wanted = findLanguage(id);
    if ((wanted == nullptr ? languageOfDesktop() : wanted->id) != inUse().language) {
        load(inUse(), id);
        for (Said& constant : constants()) {
            constant.shown = text(constant.english);
        }
    }
}

std::string_view languageInUse() {
    return inUse().language;
}

char const* text(std::string_view id) {
    TextsInUse const& all = inUse();
    char const* found = all.texts.find(id);
    found = found == nullptr ? all.english.find(id) : found;
    return found == nullptr ? id.data() : found;
}

std::string textOfLanguage(std::string_view language, std::string_view id) {
    Catalogue const texts(homeFolder() / "assets" / "text", language);
    char const* const found = texts.find(id);
    return found == nullptr ? std::string(id) : found;
}

std::locale const& numberLocale() {
    return inUse().numbers;
}

std::string translated(std::string const& english) {
    constexpr std::size_t mostKept = 2000;
    TextsInUse& all = inUse();
    if (auto const known = all.translated.find(english); known != all.translated.end()) {
        return known->second;
    }
    if (all.translated.size() >= mostKept) {
        all.translated.clear();
    }
    return all.translated.emplace(english, all.texts.translated(english)).first->second;
}

std::string shownName(std::string const& object) {
    return inUse().texts.names().bare(object);
}

std::string shownArea(std::string const& called) {
    constexpr std::string_view article = "the ";
    std::string const own = called.starts_with(article) ? called.substr(article.size()) : called;
    GermanNames const& names = inUse().texts.names();
    return names.understands(own) ? names.bare(own) : called;
}

Noun theObject(std::string const& object) {
    return speechInUse().the(object);
}

Catalogue const* catalogueInUse() {
    return inUse().speech == nullptr ? nullptr : &inUse().texts;
}

Speech const& speechInUse() {
    TextsInUse const& all = inUse();
    return all.speech == nullptr ? englishSpeech() : *all.speech;
}

std::string localNumber(std::string number) {
    char const point = std::use_facet<std::numpunct<char>>(numberLocale()).decimal_point();
    std::replace(number.begin(), number.end(), '.', point);
    return number;
}

char const* const& said(char const* english) {
    return constants().emplace_back(Said{english, english}).shown;
}

std::vector<char const*> allSaid() {
    std::vector<char const*> all;
    for (Said const& constant : constants()) {
        all.push_back(constant.english);
    }
    return all;
}

} // namespace trembler::ui
