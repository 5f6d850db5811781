// All tokens of a script's text, to look back and ahead in.
#include "lua/sandbox/source/tokens.hpp"

#include <algorithm>
#include <array>

namespace trembler::lua {
namespace {

bool isKeyword(std::string_view word) {
    constexpr std::array<std::string_view, 21> keywords{
        "and",   "break", "do",  "else", "elseif", "end",    "false", "for",  "function", "if",   "in",
        "local", "nil",   "not", "or",   "repeat", "return", "then",  "true", "until",    "while"};
    return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

} // namespace

Tokens::Tokens(std::string_view text) {
    SourceScanner scanner(text);
    for (auto kind = scanner.next(); kind != TokenKind::end; kind = scanner.next()) {
        all_.push_back({kind, scanner.token(), scanner.begin(), scanner.end(), scanner.line()});
    }
}

Token const& Tokens::token(std::size_t at) const {
    static Token const none;
    return at < all_.size() ? all_[at] : none;
}

bool Tokens::isName(std::size_t at) const {
    return token(at).kind == TokenKind::name && !isKeyword(token(at).text);
}

bool beginsStatement(std::string_view word) {
    constexpr std::array<std::string_view, 12> keywords{
        "break", "do", "else", "elseif", "end", "for", "if", "local", "repeat", "return", "until", "while"};
    return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

} // namespace trembler::lua
