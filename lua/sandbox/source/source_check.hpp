// The checks of the text of a script before Lua sees it.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace trembler::lua {

/// The fault of a script's text, and its line.
struct SourceFault {
    std::size_t line = 0; ///< from 1; 0: the text as a whole
    std::string message;
};

/// Refuses text that is too long, compiled code, string literals that are too long, what tokenFault()
/// refuses, and the operator ^, whose results differ between compiled and interpreted code. Does not check
/// whether the text is otherwise Lua.
[[nodiscard]] std::optional<SourceFault> faultInSource(std::string_view text);

/// Every name and every string literal in the text. A script can reach a field by one of them, or by a name
/// that it puts together while it runs.
[[nodiscard]] std::set<std::string, std::less<>> wordsOf(std::string_view text);

} // namespace trembler::lua
