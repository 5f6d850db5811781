// What must hold for every text that a script, or the player, gets to see.
#pragma once

#include "lua/sandbox/limits.hpp"
#include "lua/sandbox/number_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <string_view>

namespace trembler::lua {

/// Whether a text has something in it that looks like an address: 0x and four digits or more, or ten or more
/// hexadecimal digits with at least two different letters and two different digits.
inline bool hasAddress(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        std::set<char> letters;
        std::set<char> digits;
        while (end < text.size() && std::isxdigit(static_cast<unsigned char>(text[end])) != 0) {
            (std::isdigit(static_cast<unsigned char>(text[end])) != 0 ? digits : letters).insert(text[end]);
            ++end;
        }
        bool const marked = i >= 2 && (text.substr(i - 2, 2) == "0x" || text.substr(i - 2, 2) == "0X");
        if (marked ? end - i >= 4 : end - i >= 10 && letters.size() >= 2 && digits.size() >= 2) {
            return true;
        }
        i = std::max(end, i + 1);
    }
    return false;
}

/// Of a text that a script has; `most`: its limit, in bytes.
inline void expectHarmless(std::string const& text, std::size_t most = longestString + 2) {
    EXPECT_FALSE(hasAddress(text)) << text;
    EXPECT_LE(text.size(), most) << text.substr(0, 100) << "...";
    EXPECT_FALSE(readsAsLongNumber(text)) << text.substr(0, 100);
    for (char const* const part : {"builtin", "(prelude)", "(driver)", "__count", "\xE2\x80\xA5"}) {
        EXPECT_EQ(text.find(part), std::string::npos) << text;
    }
}

} // namespace trembler::lua
