// A field for texts of several lines, whose long lines are wrapped as in a letter.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace trembler::ui {

/// A text with the line breaks of its field, "\r\n", beside its own, "\n"; and a place in it.
struct WrappedText {
    std::string text;
    std::size_t cursor = 0; ///< in bytes

    friend bool operator==(WrappedText const&, WrappedText const&) = default;
};

/// Breaks the lines of a text (UTF-8, without "\r") after blanks, and words that are longer than a line where
/// the line ends. A cursor at such a break is at the beginning of the next line. `advance` is the width of a
/// character, in the unit of `width`.
[[nodiscard]] WrappedText wrapLines(WrappedText const& plain, float width,
                                    std::function<float(std::uint32_t)> const& advance);
/// The text without the field's breaks. Of a break of which the designer deleted the second character, as
/// Backspace does at the beginning of a line, the character before it is deleted, too.
[[nodiscard]] WrappedText unwrapLines(WrappedText const& wrapped);

/// A text of several lines, which grows from `lines` to twice as many. Returns whether it was changed.
/// `longest` is in bytes.
bool textArea(char const* label, std::string& text, float lines, std::size_t longest = 8000);

} // namespace trembler::ui
