// Texts that a hostile or careless author may put into a file, the same for the same seed.
#pragma once

#include "runtime/file/cut_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <utility>

namespace trembler::ui::test {

class AnyText {
public:
    explicit AnyText(std::uint64_t seed) : random_(seed) {}

    std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }
    bool oneIn(std::size_t count) { return below(count) == 0; }

    /// UTF-8 of up to `most` bytes: short, empty or very long, with the signs that widgets, formats and
    /// terminals understand.
    std::string text(std::size_t most = 60'000) {
        std::size_t const length = oneIn(10)  ? 0
                                   : oneIn(3) ? below(most)
                                              : below(std::min<std::size_t>(most, 60));
        std::string made;
        if (oneIn(8)) { // one sign again and again: a long word, many lines, accents without width
            std::string const sign = piece();
            while (made.size() + sign.size() <= length && !sign.empty()) {
                made += sign;
            }
            return made;
        }
        for (std::string next = piece(); made.size() + next.size() <= length; next = piece()) {
            made += next;
        }
        return made;
    }
    /// One that names accept: 1 to 100 bytes in one line, without blanks at the ends.
    std::string name() {
        std::string made = oneIn(3) ? text(100) : piece() + piece();
        std::erase_if(made, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
        made = "n" + trembler::cutText(std::move(made), 80);
        return made + std::to_string(below(100'000));
    }
    /// What may be the name of a file.
    std::string fileName() {
        std::string made = name();
        std::replace(made.begin(), made.end(), '/', '_');
        return made;
    }

private:
    std::string piece() {
        static std::array<std::string, 32> const pieces{
            "a",      "word ",   "Wort",   " ",      "\n",     "\t",         "##",     "###",
            "%s%n%d", "{}",      "{0}",    "{name}", "\\n",    "\"",         "'",      "<b>",
            "\u00E4", "\u20AC",  "\u0301", "\u202E", "\u200D", "\U0001F600", "\u00AD", "\u2028",
            "\x7f",   "\x1b[2J", "\x01",   "\r",     "0",      "-1e308",     "\uFFFD", "averylongword"};
        return pieces[below(pieces.size())];
    }

    std::mt19937_64 random_;
};

} // namespace trembler::ui::test
