#include "lua/sandbox/number_text.hpp"

#include "lua/sandbox/limits.hpp"

#include <algorithm>
#include <cctype>

namespace trembler::lua {
namespace {

/// The value of up to `most` digits of a base at the beginning of a text, which are taken off it.
unsigned takeNumber(std::string_view& text, unsigned base, std::size_t most) {
    unsigned value = 0;
    for (; most > 0 && !text.empty(); --most) {
        constexpr std::string_view digits = "0123456789abcdef";
        auto const digit =
            digits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(text.front()))));
        if (digit >= base) {
            break;
        }
        value = std::min(value, 0xFFFFU) * base + static_cast<unsigned>(digit);
        text.remove_prefix(1);
    }
    return value;
}

/// The string of a literal, as far as it is needed to decide whether the string reads as a number.
std::string unescaped(std::string_view literal) {
    std::string text;
    while (!literal.empty()) {
        char const c = literal.front();
        literal.remove_prefix(1);
        if (c != '\\' || literal.empty()) {
            text += c;
            continue;
        }
        char const escape = literal.front();
        unsigned code = '?'; // no part of a number, like \a, \b and quotes
        if (escape >= '0' && escape <= '9') {
            code = takeNumber(literal, 10, 3);
        } else {
            literal.remove_prefix(1);
            if (escape == 'x') {
                code = takeNumber(literal, 16, 2);
            } else if (escape == 'u' && literal.starts_with('{')) {
                literal.remove_prefix(1);
                code = takeNumber(literal, 16, literal.size());
                literal.remove_prefix(std::min<std::size_t>(1, literal.size()));
            } else if (std::string_view("nrtvf").find(escape) != std::string_view::npos) {
                code = ' ';
            }
        }
        text += code < 0x80 ? static_cast<char>(code) : '?';
    }
    return text;
}

} // namespace

bool readsAsLongNumber(std::string_view text) {
    auto const skip = [&](std::string_view characters) {
        std::size_t const count = std::min(text.find_first_not_of(characters), text.size());
        text.remove_prefix(count);
        return count;
    };
    constexpr std::string_view space = " \t\r\n\v\f";
    bool const isLong = text.size() > longestNumber;
    bool exponent = false;
    skip(space);
    if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
        text.remove_prefix(1);
    }
    bool const hex = text.starts_with("0x") || text.starts_with("0X");
    text.remove_prefix(hex ? 2 : 0);
    std::size_t const count = skip(hex ? "0123456789abcdefABCDEF." : "0123456789.");
    if (!text.empty() && std::string_view(hex ? "pP" : "eE").find(text.front()) != std::string_view::npos) {
        text.remove_prefix(1);
        if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
            text.remove_prefix(1);
        }
        exponent = skip("0123456789") > 0;
        if (!exponent) {
            return false;
        }
    }
    skip(space);
    return text.empty() && count > 0 && (isLong || exponent);
}

std::optional<SourceFault> tokenFault(SourceScanner const& scanner, SourceScanner::Kind kind) {
    std::string_view const token = scanner.token();
    if (kind == SourceScanner::Kind::string) {
        std::size_t const quotes = scanner.end() - scanner.begin() - token.size();
        std::string const text = quotes > 2 ? std::string(token) : unescaped(token); // [[...]] has no escapes
        if (readsAsLongNumber(text)) {
            return SourceFault{
                scanner.line(),
                "a string that arithmetic would take for a long number; expected a number, or another text"};
        }
    }
    bool const ascii =
        std::all_of(token.begin(), token.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    if (kind != SourceScanner::Kind::string && !ascii) {
        return SourceFault{scanner.line(), "a letter beyond ASCII; names have letters, digits and _"};
    }
    return std::nullopt;
}

std::string withCountedJoins(std::string_view text) {
    std::string made;
    std::size_t copied = 0;
    SourceScanner scanner(text);
    for (auto kind = scanner.next(); kind != SourceScanner::Kind::end; kind = scanner.next()) {
        if (kind == SourceScanner::Kind::other && scanner.token() == "..") {
            made.append(text.substr(copied, scanner.end() - copied)).append(joinerName).append("..");
            copied = scanner.end();
        }
    }
    return made.append(text.substr(copied));
}

} // namespace trembler::lua
