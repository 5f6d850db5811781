#include "lua/sandbox/source/source_check.hpp"

#include "lua/sandbox/limits.hpp"
#include "lua/sandbox/number_text.hpp"
#include "lua/sandbox/source/scanner.hpp"

#include <fmt/format.h>

namespace trembler::lua {

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
    SourceScanner scanner(text);
    for (auto kind = scanner.next(); kind != SourceScanner::Kind::end; kind = scanner.next()) {
        if (kind == SourceScanner::Kind::string && scanner.token().size() > longestLiteral) {
            return SourceFault{scanner.line(), fmt::format("a string of {} bytes; expected at most {}",
                                                           scanner.token().size(), longestLiteral)};
        }
        if (auto const fault = tokenFault(scanner, kind)) {
            return fault;
        }
        if (kind == SourceScanner::Kind::other && scanner.token() == "^") {
            return SourceFault{scanner.line(),
                               "there is no operator ^, as its results differ from machine to machine; "
                               "write x * x, math.sqrt(x) or math.exp(y * math.log(x))"};
        }
    }
    if (scanner.unclear()) {
        return SourceFault{0,
                           "a string or a comment has no end, or a string goes on in another line; expected "
                           "\"...\" in one line, with \\n for a line's end, or [[...]]"};
    }
    return std::nullopt;
}

std::set<std::string, std::less<>> wordsOf(std::string_view text) {
    std::set<std::string, std::less<>> words;
    SourceScanner scanner(text);
    for (auto kind = scanner.next(); kind != SourceScanner::Kind::end; kind = scanner.next()) {
        if (kind != SourceScanner::Kind::other) {
            words.emplace(scanner.token());
        }
    }
    return words;
}

} // namespace trembler::lua
