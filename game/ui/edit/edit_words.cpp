#include "game/ui/edit/edit_words.hpp"

#include "game/ui/shared/texts.hpp"

#include <deque>
#include <string_view>

namespace trembler::ui::words {
namespace {

struct EditWordEntry {
    char const* english;
    char const* shown;
};

struct EditWordList {
    std::deque<EditWordEntry> all; // a deque, as references to its elements are kept
    std::string language = "en";
};

EditWordList& knownEditWords() {
    static EditWordList words;
    return words;
}

} // namespace

char const* const& editWord(char const* english) {
    return knownEditWords().all.emplace_back(EditWordEntry{english, english}).shown;
}

void followLanguage() {
    EditWordList& words = knownEditWords();
    if (words.language == languageInUse()) {
        return;
    }
    words.language = languageInUse();
    for (EditWordEntry& word : words.all) {
        word.shown = text(word.english);
    }
}

std::vector<char const*> allEditWords() {
    std::vector<char const*> all;
    for (EditWordEntry const& word : knownEditWords().all) {
        all.push_back(word.english);
    }
    return all;
}

} // namespace trembler::ui::words
