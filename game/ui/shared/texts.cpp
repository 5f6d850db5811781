#include "game/ui/shared/texts.hpp"

#include "puzzle/data/game_data.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <system_error>
#include <vector>

namespace trembler::ui {
namespace {

constexpr std::array<Language, 2> knownLanguages{{{"en", "English"}, {"de", "Deutsch"}}};

using TextMap = std::map<std::string, std::string, std::less<>>;

struct TextsInUse {
    std::string_view language;
    TextMap texts;
};

void addTextsOf(TextMap& texts, std::filesystem::path const& file) {
    std::ifstream in(file);
    auto const all = nlohmann::json::parse(in, nullptr, false);
    if (!all.is_object()) {
        return;
    }
    for (auto const& [id, value] : all.items()) {
        if (value.is_string()) {
            texts[id] = value.get<std::string>();
        }
    }
}

/// LANGUAGE.json, whose texts have ids, and the files of the folder LANGUAGE, whose texts have their English
/// text for it.
void addTexts(TextMap& texts, std::string_view language) {
    auto const path = homeFolder() / "assets" / "text" / std::string(language);
    addTextsOf(texts, path.string() + ".json");
    std::error_code ignored;
    std::vector<std::filesystem::path> files;
    for (std::filesystem::directory_iterator at(path, ignored), end; !ignored && at != end;
         at.increment(ignored)) {
        files.push_back(at->path());
    }
    std::sort(files.begin(), files.end());
    for (auto const& file : files) {
        addTextsOf(texts, file);
    }
}

Language const* findLanguage(std::string_view id) {
    auto const found = std::find_if(knownLanguages.begin(), knownLanguages.end(),
                                    [&](Language const& language) { return language.id == id; });
    return found == knownLanguages.end() ? nullptr : &*found;
}

TextsInUse loaded(std::string_view id) {
    Language const* const wanted = findLanguage(id);
    TextsInUse texts{wanted == nullptr ? languageOfDesktop() : wanted->id, {}};
    addTexts(texts.texts, "en");
    if (texts.language != "en") {
        addTexts(texts.texts, texts.language);
    }
    return texts;
}

TextsInUse& inUse() {
    static TextsInUse texts = loaded("en");
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
        inUse() = loaded(id);
    }
}

std::string_view languageInUse() {
    return inUse().language;
}

char const* text(std::string_view id) {
    TextMap const& texts = inUse().texts;
    auto const found = texts.find(id);
    return found == texts.end() ? id.data() : found->second.c_str();
}

} // namespace trembler::ui
