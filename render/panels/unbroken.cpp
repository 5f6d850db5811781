#include "render/panels/unbroken.hpp"

namespace trembler::render {
namespace {

constexpr std::size_t shortWord = 3; // letters

bool digitAt(std::string_view text, std::size_t i) {
    return i < text.size() && text[i] >= '0' && text[i] <= '9';
}

bool letterAt(std::string_view text, std::size_t i) {
    return i < text.size() && ((text[i] >= 'a' && text[i] <= 'z') || (text[i] >= 'A' && text[i] <= 'Z'));
}

/// The space at `i` follows a short word behind a number, and a number or the second part of a unit follows
/// it.
bool withinCountOrUnit(std::string_view text, std::size_t i) {
    std::size_t word = i;
    while (word > 0 && letterAt(text, word - 1)) {
        --word;
    }
    bool const behindNumber = word > 1 && text[word - 1] == ' ' && digitAt(text, word - 2);
    bool const newtonMetres = text.substr(word, i - word + 2) == "N m" && !letterAt(text, i + 2);
    return behindNumber && i > word && i - word <= shortWord && (digitAt(text, i + 1) || newtonMetres);
}

} // namespace

std::string unbroken(std::string_view text) {
    std::string made;
    for (std::size_t i = 0; i < text.size(); ++i) {
        bool const stays = text[i] == ' ' && ((i > 0 && digitAt(text, i - 1)) || withinCountOrUnit(text, i));
        if (stays) {
            made += "\u00A0";
        } else {
            made += text[i];
        }
    }
    return made;
}

} // namespace trembler::render
