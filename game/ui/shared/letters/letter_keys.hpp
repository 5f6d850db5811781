// The keys of the keyboard on the screen: which there are, and where. No window, no drawing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace trembler::ui {

enum class KeyAct : std::uint8_t { type, shift, signs, blank, newLine, left, right, erase, cancel, done };

struct LetterKey {
    KeyAct act = KeyAct::type;
    std::string text;    ///< UTF-8; the text that KeyAct::type types
    std::size_t row = 0; ///< from the top
    double left = 0;     ///< of its row, in widths of a letter
    double width = 1;
};

/// Which keys are shown.
enum class KeyPage : std::uint8_t { letters, capitals, signs, numbers };

struct KeysWanted {
    KeyPage page = KeyPage::letters;
    bool german = false;  ///< as on German keyboards: QWERTZ, with umlauts
    bool newLine = false; ///< the text has several lines

    friend bool operator==(KeysWanted const&, KeysWanted const&) = default;
};

/// Every row has this width.
inline constexpr double rowOfKeys = 11;
inline constexpr std::size_t rowsOfKeys = 5;

/// Row by row, from the left. The keys of a row fill it.
[[nodiscard]] std::vector<LetterKey> letterKeys(KeysWanted const& wanted);

/// The index of the key beside, above or below another one (one of `x` and `y` is -1 or 1, the other 0; y
/// down). Behind the last key of a row or a column is the first one. `aim` is the place in the row from which
/// up and down go, in widths of a letter; it follows sideways moves.
[[nodiscard]] std::size_t keyBeside(std::vector<LetterKey> const& keys, std::size_t from, int x, int y,
                                    double& aim);

} // namespace trembler::ui
