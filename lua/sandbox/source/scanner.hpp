// The tokens of a script's text, as LuaJIT's own lexer sees them.
#pragma once

#include <cstddef>
#include <string_view>

namespace trembler::lua {

/// Walks through a text, token by token. Comments are skipped. In a text that LuaJIT accepts, the tokens are
/// LuaJIT's own, because the instructions of a script are counted by them; in any other text they may be
/// different.
class SourceScanner {
public:
    enum class Kind {
        end,
        name, ///< keywords too
        number,
        string, ///< its text has no quotes, and its escapes as they stand
        other,  ///< an operator, with all its characters
    };

    explicit SourceScanner(std::string_view text);

    Kind next();
    [[nodiscard]] std::string_view token() const { return token_; }
    /// From 1.
    [[nodiscard]] std::size_t line() const { return tokenLine_; }
    /// Where the token begins and ends in the text, in bytes.
    [[nodiscard]] std::size_t begin() const { return begin_; }
    [[nodiscard]] std::size_t end() const { return at_; }
    /// Whether a string has been met that has no end in its line, or an escape that is not allowed in scripts
    /// (\z and a line's end), by which strings and code might be taken for one another.
    [[nodiscard]] bool unclear() const { return unclear_; }

private:
    void skip();
    void skipLine();
    void quoted(char quote);
    void number();
    bool longBracket();

    std::string_view text_;
    std::string_view token_;
    std::size_t at_ = 0;
    std::size_t begin_ = 0;
    std::size_t line_ = 1;
    std::size_t tokenLine_ = 1;
    bool unclear_ = false;
};

} // namespace trembler::lua
