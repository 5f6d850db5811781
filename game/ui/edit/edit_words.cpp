#include "game/ui/edit/edit_words.hpp"

#include "game/ui/shared/texts.hpp"

namespace trembler::ui::words {
namespace {

std::vector<char const*>& knownEditWords() {
    static std::vector<char const*> words;
    return words;
}

} // namespace

char const* const& editWord(char const* english) {
    knownEditWords().push_back(english);
    return said(english);
}

std::vector<char const*> allEditWords() {
    return knownEditWords();
}

} // namespace trembler::ui::words
