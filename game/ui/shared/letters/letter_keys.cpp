#include "game/ui/shared/letters/letter_keys.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace trembler::ui {
namespace {

using FourRows = std::array<std::string_view, 4>;

constexpr FourRows englishLetters{"1234567890-", "qwertyuiop'", "asdfghjkl;:", "zxcvbnm,.?!"};
constexpr FourRows germanLetters{"1234567890ß", "qwertzuiopü", "asdfghjklöä", "yxcvbnm,.-?"};
constexpr FourRows englishCapitals{"1234567890_", "QWERTYUIOP\"", "ASDFGHJKL;:", "ZXCVBNM,.?!"};
constexpr FourRows germanCapitals{"1234567890ß", "QWERTZUIOPÜ", "ASDFGHJKLÖÄ", "YXCVBNM;:_!"};
constexpr FourRows signs{"!?.,:;'\"()&", "+-*/=<>%#@~", "[]{}\\|_^$€°", "äöüßÄÖÜéè–…"};
/// Three columns of three; the others would be letters.
constexpr FourRows numbers{"789", "456", "123", "-0."};

/// The first character of a text, UTF-8.
std::string_view firstCharacter(std::string_view text) {
    std::size_t size = 1;
    while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) {
        ++size;
    }
    return text.substr(0, size);
}

FourRows const& rowsOf(KeysWanted const& wanted) {
    switch (wanted.page) {
    case KeyPage::numbers:
        return numbers;
    case KeyPage::signs:
        return signs;
    case KeyPage::capitals:
        return wanted.german ? germanCapitals : englishCapitals;
    case KeyPage::letters:
        break;
    }
    return wanted.german ? germanLetters : englishLetters;
}

double middleOf(LetterKey const& key) {
    return key.left + 0.5 * key.width;
}

} // namespace

std::vector<LetterKey> letterKeys(KeysWanted const& wanted) {
    std::vector<LetterKey> keys;
    FourRows const& rows = rowsOf(wanted);
    std::size_t const perRow = wanted.page == KeyPage::numbers ? 3 : static_cast<std::size_t>(rowOfKeys);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        std::string_view rest = rows[row];
        double const width = rowOfKeys / static_cast<double>(perRow);
        for (std::size_t column = 0; column < perRow && !rest.empty(); ++column) {
            std::string_view const character = firstCharacter(rest);
            rest.remove_prefix(character.size());
            keys.push_back(
                {KeyAct::type, std::string(character), row, static_cast<double>(column) * width, width});
        }
    }
    double left = 0;
    auto const add = [&](KeyAct act, double width) {
        keys.push_back({act, {}, rows.size(), left, width});
        left += width;
    };
    bool const letters = wanted.page != KeyPage::numbers;
    if (letters) {
        add(KeyAct::shift, 1);
    }
    add(KeyAct::signs, letters ? 1 : 1.5);
    if (letters) {
        add(KeyAct::blank, wanted.newLine ? 2.5 : 3.5);
    }
    if (wanted.newLine) {
        add(KeyAct::newLine, 1);
    }
    double const width = (rowOfKeys - left) / 5;
    for (KeyAct const act : {KeyAct::left, KeyAct::right, KeyAct::erase, KeyAct::cancel, KeyAct::done}) {
        add(act, width);
    }
    return keys;
}

std::size_t keyBeside(std::vector<LetterKey> const& keys, std::size_t from, int x, int y, double& aim) {
    LetterKey const& here = keys[from];
    auto const around = [](std::size_t at, int by, std::size_t count) {
        return (at + (by < 0 ? count - 1 : by > 0 ? 1 : 0)) % count;
    };
    std::size_t const row = around(here.row, y, rowsOfKeys);
    std::size_t first = keys.size();
    std::size_t count = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i].row == row) {
            first = std::min(first, i);
            ++count;
        }
    }
    if (x != 0) {
        std::size_t const column = around(from - first, x, count);
        aim = middleOf(keys[first + column]);
        return first + column;
    }
    std::size_t best = first;
    for (std::size_t i = first; i < first + count; ++i) {
        if (std::abs(middleOf(keys[i]) - aim) < std::abs(middleOf(keys[best]) - aim)) {
            best = i;
        }
    }
    // A wide key is under all that is above it.
    for (std::size_t i = first; i < first + count; ++i) {
        if (keys[i].left <= aim && aim < keys[i].left + keys[i].width) {
            best = i;
        }
    }
    return best;
}

} // namespace trembler::ui
