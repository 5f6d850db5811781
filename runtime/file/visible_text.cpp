#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>

namespace trembler {
namespace {

struct CodeRange {
    char32_t first;
    char32_t last;
};

/// Unicode 15: Cc; the invisible characters of Cf; the separators Zl and Zp. Ascending.
constexpr std::array<CodeRange, 13> unseen{{{0x00, 0x1F},
                                            {0x7F, 0x9F},
                                            {0xAD, 0xAD},         // soft hyphen
                                            {0x61C, 0x61C},       // Arabic letter mark
                                            {0x180E, 0x180E},     // Mongolian vowel separator
                                            {0x200B, 0x200F},     // zero-width characters; marks of direction
                                            {0x2028, 0x202E},     // separators, embeddings, overrides
                                            {0x2060, 0x206F},     // joiners, isolates, deprecated formats
                                            {0xFEFF, 0xFEFF},     // byte order mark
                                            {0xFFF9, 0xFFFB},     // annotations
                                            {0x13430, 0x1343F},   // hieroglyph formats
                                            {0x1D173, 0x1D17A},   // musical formats
                                            {0xE0000, 0xE007F}}}; // tags; private use is drawn by the font

bool isUnseen(char32_t c) {
    auto const after =
        std::upper_bound(unseen.begin(), unseen.end(), c,
                         [](char32_t wanted, CodeRange const& range) { return wanted < range.first; });
    return after != unseen.begin() && c <= std::prev(after)->last;
}

/// The number of bytes of a character that begins with this byte; 0 if no character does.
std::size_t lengthFrom(unsigned char lead) {
    return lead < 0x80U ? 1 : lead < 0xC2U ? 0 : lead < 0xE0U ? 2 : lead < 0xF0U ? 3 : lead < 0xF5U ? 4 : 0;
}

/// Whether the second byte of a character may be this one: no overlong forms, no surrogates, nothing above
/// U+10FFFF (RFC 3629).
bool mayFollow(unsigned char lead, unsigned char second) {
    unsigned const low = lead == 0xE0U ? 0xA0U : lead == 0xF0U ? 0x90U : 0x80U;
    unsigned const high = lead == 0xEDU ? 0x9FU : lead == 0xF4U ? 0x8FU : 0xBFU;
    return second >= low && second <= high;
}

struct Character {
    std::size_t length;           ///< bytes
    std::optional<char32_t> code; ///< nothing for a byte that is not UTF-8
};

Character characterAt(std::string_view text, std::size_t at) {
    auto const byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
    std::size_t const length = lengthFrom(byte(0));
    if (length == 0 || at + length > text.size()) {
        return {1, {}};
    }
    if (length == 1) {
        return {1, byte(0)};
    }
    char32_t code = byte(0) & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if (i == 1 ? !mayFollow(byte(0), byte(1)) : (byte(i) & 0xC0U) != 0x80U) {
            return {1, {}};
        }
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    return {length, code};
}

std::string replaced(std::string_view text, bool lines) {
    std::string made;
    made.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        auto const [length, code] = characterAt(text, at);
        if (!code) {
            fmt::format_to(std::back_inserter(made), "<{:02X}>", static_cast<unsigned char>(text[at]));
        } else if (isUnseen(*code) && !(lines && (*code == U'\n' || *code == U'\t'))) {
            fmt::format_to(std::back_inserter(made), "<U+{:04X}>", static_cast<std::uint32_t>(*code));
        } else {
            made += text.substr(at, length);
        }
        at += length;
    }
    return made;
}

} // namespace

std::string visible(std::string_view text) {
    return replaced(text, false);
}

std::string visibleLines(std::string_view text) {
    return replaced(text, true);
}

std::size_t characterLength(std::string_view text) {
    if (text.empty()) {
        return 0;
    }
    Character const first = characterAt(text, 0);
    return first.code ? first.length : 0;
}

bool hasControlCharacter(std::string_view text) {
    return std::any_of(text.begin(), text.end(), [](char letter) {
        auto const code = static_cast<unsigned char>(letter);
        return code < 0x20 || code == 0x7f;
    });
}

std::size_t unfinishedCharacter(std::string_view text) {
    for (std::size_t back = 1; back <= 3 && back <= text.size(); ++back) {
        auto const lead = static_cast<unsigned char>(text[text.size() - back]);
        if ((lead & 0xC0U) == 0x80U) {
            continue; // somewhere inside a character
        }
        bool const possible =
            lengthFrom(lead) > back &&
            (back == 1 || mayFollow(lead, static_cast<unsigned char>(text[text.size() - back + 1])));
        return possible ? back : 0;
    }
    return 0;
}

std::string escapedJson(std::string_view printed) {
    std::string made;
    made.reserve(printed.size());
    for (std::size_t at = 0; at < printed.size();) {
        auto const [length, code] = characterAt(printed, at);
        if (!code || !isUnseen(*code) || *code == U'\n' || *code == U'\t' || *code == U'\r') {
            made += printed.substr(at, length);
        } else if (*code < 0x10000) {
            fmt::format_to(std::back_inserter(made), "\\u{:04x}", static_cast<std::uint32_t>(*code));
        } else { // a pair of surrogates (RFC 8259, 7)
            std::uint32_t const rest = static_cast<std::uint32_t>(*code) - 0x10000U;
            fmt::format_to(std::back_inserter(made), "\\u{:04x}\\u{:04x}", 0xD800U + (rest >> 10U),
                           0xDC00U + (rest & 0x3FFU));
        }
        at += length;
    }
    return made;
}

} // namespace trembler
