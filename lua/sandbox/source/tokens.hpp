// All tokens of a script's text, to look back and ahead in.
#pragma once

#include "lua/sandbox/source/scanner.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace trembler::lua {

using TokenKind = SourceScanner::Kind;

struct Token {
    TokenKind kind = TokenKind::end;
    std::string_view text;
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t line = 0;

    [[nodiscard]] bool is(std::string_view wanted) const {
        return text == wanted && (kind == TokenKind::name || kind == TokenKind::other);
    }
};

/// The tokens of a text, in order. They point into the text.
class Tokens {
public:
    explicit Tokens(std::string_view text);

    [[nodiscard]] std::size_t size() const { return all_.size(); }
    [[nodiscard]] bool empty() const { return all_.empty(); }
    [[nodiscard]] Token const& front() const { return all_.front(); }
    [[nodiscard]] Token const& back() const { return all_.back(); }
    [[nodiscard]] auto begin() const { return all_.begin(); }
    [[nodiscard]] auto end() const { return all_.end(); }
    /// The token at a place; an empty one behind the last.
    [[nodiscard]] Token const& token(std::size_t at) const;
    /// Whether the token is a name and no keyword.
    [[nodiscard]] bool isName(std::size_t at) const;

private:
    std::vector<Token> all_;
};

/// Keywords that stand in no expression: the condition of 'until' has ended before them.
[[nodiscard]] bool beginsStatement(std::string_view word);

} // namespace trembler::lua
