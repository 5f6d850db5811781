#include "lua/sandbox/source/scanner.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace trembler::lua {
namespace {

// Like LuaJIT, which takes every byte above 127 for a letter.
bool startsName(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           static_cast<unsigned char>(c) > 127;
}
bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isLineEnd(char c) {
    return c == '\n' || c == '\r';
}

} // namespace

SourceScanner::SourceScanner(std::string_view text) : text_(text) {
    if (text_.starts_with("\xef\xbb\xbf")) { // the mark of UTF-8, which LuaJIT skips
        at_ = 3;
    }
    if (at_ < text_.size() && text_[at_] == '#') { // and a first line for a shell
        skipLine();
    }
}

SourceScanner::Kind SourceScanner::next() {
    skip();
    tokenLine_ = line_;
    begin_ = at_;
    if (at_ >= text_.size()) {
        token_ = {};
        return Kind::end;
    }
    char const c = text_[at_];
    char const after = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
    if (startsName(c)) {
        while (at_ < text_.size() && (startsName(text_[at_]) || isDigit(text_[at_]))) {
            ++at_;
        }
        token_ = text_.substr(begin_, at_ - begin_);
        return Kind::name;
    }
    if (isDigit(c) || (c == '.' && isDigit(after))) {
        number();
        return Kind::number;
    }
    if (c == '"' || c == '\'') {
        quoted(c);
        return Kind::string;
    }
    if (c == '[' && longBracket()) {
        return Kind::string;
    }
    constexpr std::array<std::string_view, 7> longer{"...", "..", "==", "~=", "<=", ">=", "::"};
    auto const found = std::find_if(longer.begin(), longer.end(), [this](std::string_view operation) {
        return text_.substr(at_, operation.size()) == operation;
    });
    at_ += found == longer.end() ? 1 : found->size();
    token_ = text_.substr(begin_, at_ - begin_);
    return Kind::other;
}

void SourceScanner::skipLine() {
    while (at_ < text_.size() && !isLineEnd(text_[at_])) {
        ++at_;
    }
}

void SourceScanner::skip() {
    while (at_ < text_.size()) {
        char const c = text_[at_];
        if (c == '\n') {
            ++line_;
            ++at_;
        } else if (c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f') {
            ++at_;
        } else if (text_.substr(at_, 2) == "--") {
            at_ += 2;
            if (!longBracket()) {
                skipLine();
            }
        } else {
            return;
        }
    }
}

void SourceScanner::number() {
    std::size_t const start = at_;
    char const exponent =
        text_[at_] == '0' && at_ + 1 < text_.size() && (text_[at_ + 1] | 0x20) == 'x' ? 'p' : 'e';
    while (at_ < text_.size()) {
        char const c = text_[at_];
        bool const sign = (c == '-' || c == '+') && at_ > start && (text_[at_ - 1] | 0x20) == exponent;
        if (!startsName(c) && !isDigit(c) && c != '.' && !sign) {
            break;
        }
        ++at_;
    }
    token_ = text_.substr(start, at_ - start);
}

void SourceScanner::quoted(char quote) {
    std::size_t const start = ++at_;
    while (at_ < text_.size() && text_[at_] != quote && !isLineEnd(text_[at_])) {
        if (text_[at_] == '\\' && at_ + 1 < text_.size()) {
            ++at_;
            unclear_ = unclear_ || text_[at_] == 'z' || isLineEnd(text_[at_]);
        }
        ++at_;
    }
    token_ = text_.substr(std::min(start, text_.size()), at_ - start);
    if (at_ < text_.size() && text_[at_] == quote) {
        ++at_;
    } else {
        unclear_ = true;
    }
}

// A text in long brackets, [[...]] or [=[...]=], if one begins here.
bool SourceScanner::longBracket() {
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
    unclear_ = unclear_ || end == std::string_view::npos;
    token_ = text_.substr(start, stop - start);
    line_ += static_cast<std::size_t>(std::count(token_.begin(), token_.end(), '\n'));
    at_ = end == std::string_view::npos ? text_.size() : end + close.size();
    return true;
}

} // namespace trembler::lua
