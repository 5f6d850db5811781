// A check that keeps arithmetic from converting texts whose conversion takes long.
//
// Lua's arithmetic takes a text for a number where it reads as one: "1e308" + 0. That is one instruction, and
// for many digits or a large exponent it takes up to 0.2 ms, which nothing counts or bounds. So no script
// receives such a text: literals are refused, and functions that make texts at run time put them in
// brackets. Joining with .. is an instruction of its own, so a script's text is changed: between the operands
// of each .. stands a name whose value has a metamethod, in which the host joins them.
#pragma once

#include "lua/sandbox/source/scanner.hpp"
#include "lua/sandbox/source/source_check.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace trembler::lua {

/// Whether arithmetic takes a text for a number, and the text has more than longestNumber characters or an
/// exponent.
[[nodiscard]] bool readsAsLongNumber(std::string_view text);

/// The name between the operands of .., U+2025: no script can write it, as tokenFault() refuses such letters.
inline constexpr std::string_view joinerName = "\xE2\x80\xA5";

/// The fault of a token: a string that reads as a long number, or a name with letters beyond ASCII.
[[nodiscard]] std::optional<SourceFault> tokenFault(SourceScanner const& scanner, SourceScanner::Kind kind);

/// A text without faults in which every `a .. b` is `a .. JOINER .. b`. Lines are those of the text.
[[nodiscard]] std::string withCountedJoins(std::string_view text);

} // namespace trembler::lua
