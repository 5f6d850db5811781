#include "lua/sandbox/source_check.hpp"

#include "lua/sandbox/limits.hpp"

#include <fmt/format.h>

namespace trembler::lua {
namespace {

bool startsName(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Walks through a text, token by token: names, string literals, and single characters of everything else.
/// Comments are skipped.
class Scanner {
public:
    enum class Kind { end, name, string, other };

    explicit Scanner(std::string_view text) : text_(text) {}

    /// The next token; its text without quotes and with escapes as they stand.
    Kind next() {
        skip();
        tokenLine_ = line_;
        if (at_ >= text_.size()) {
            return Kind::end;
        }
        std::size_t const start = at_;
        char const c = text_[at_];
        if (startsName(c)) {
            while (at_ < text_.size() && (startsName(text_[at_]) || isDigit(text_[at_]))) {
                ++at_;
            }
            token_ = text_.substr(start, at_ - start);
            return Kind::name;
        }
        if (c == '"' || c == '\'') {
            quoted(c);
            return Kind::string;
        }
        if (c == '[') {
            if (long_()) {
                return Kind::string;
            }
        }
        token_ = text_.substr(start, 1);
        ++at_;
        return Kind::other;
    }
    [[nodiscard]] std::string_view token() const { return token_; }
    [[nodiscard]] std::size_t line() const { return tokenLine_; }

private:
    void skip() {
        while (at_ < text_.size()) {
            char const c = text_[at_];
            if (c == '\n') {
                ++line_;
                ++at_;
            } else if (c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f') {
                ++at_;
            } else if (text_.substr(at_, 2) == "--") {
                at_ += 2;
                if (!long_()) {
                    while (at_ < text_.size() && text_[at_] != '\n') {
                        ++at_;
                    }
                }
            } else {
                return;
            }
        }
    }
    void quoted(char quote) {
        std::size_t const start = ++at_;
        while (at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n') {
            if (text_[at_] == '\\' && at_ + 1 < text_.size()) {
                ++at_;
                line_ += text_[at_] == '\n' ? 1 : 0;
            }
            ++at_;
        }
        token_ = text_.substr(start, at_ - start);
        at_ += at_ < text_.size() && text_[at_] == quote ? 1 : 0;
    }
    /// A text in long brackets, [[...]] or [=[...]=], if one begins here.
    bool long_() {
        std::size_t level = 0;
        if (at_ >= text_.size() || text_[at_] != '[') {
            return false;
        }
        std::size_t look = at_ + 1;
        while (look < text_.size() && text_[look] == '=') {
            ++look;
            ++level;
        }
        if (look >= text_.size() || text_[look] != '[') {
            return false;
        }
        std::size_t const start = look + 1;
        std::string const close = "]" + std::string(level, '=') + "]";
        std::size_t const end = text_.find(close, start);
        std::size_t const stop = end == std::string_view::npos ? text_.size() : end;
        token_ = text_.substr(start, stop - start);
        for (char const c : token_) {
            line_ += c == '\n' ? 1 : 0;
        }
        at_ = end == std::string_view::npos ? text_.size() : end + close.size();
        return true;
    }

    std::string_view text_;
    std::string_view token_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    std::size_t tokenLine_ = 1;
};

} // namespace

std::optional<SourceFault> faultInSource(std::string_view text) {
    if (text.size() > longestSource) {
        return SourceFault{
            0, fmt::format("the script has {} bytes; expected at most {}", text.size(), longestSource)};
    }
    if (text.starts_with('\x1b')) {
        return SourceFault{1, "this is compiled code; expected the text of a script"};
    }
    if (text.find('\0') != std::string_view::npos) {
        return SourceFault{0, "the script has a zero byte in it; expected text"};
    }
    Scanner scanner(text);
    for (auto kind = scanner.next(); kind != Scanner::Kind::end; kind = scanner.next()) {
        if (kind == Scanner::Kind::string && scanner.token().size() > longestLiteral) {
            return SourceFault{scanner.line(), fmt::format("a string of {} bytes; expected at most {}",
                                                           scanner.token().size(), longestLiteral)};
        }
        if (kind == Scanner::Kind::other && scanner.token() == "^") {
            return SourceFault{scanner.line(),
                               "there is no operator ^, as its results differ from machine to machine; "
                               "write x * x, math.sqrt(x) or math.exp(y * math.log(x))"};
        }
    }
    return std::nullopt;
}

std::set<std::string, std::less<>> wordsOf(std::string_view text) {
    std::set<std::string, std::less<>> words;
    Scanner scanner(text);
    for (auto kind = scanner.next(); kind != Scanner::Kind::end; kind = scanner.next()) {
        if (kind != Scanner::Kind::other) {
            words.emplace(scanner.token());
        }
    }
    return words;
}

} // namespace trembler::lua
