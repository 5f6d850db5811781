// Text from outside made safe for a terminal: characters that would move its cursor, change its colours or
// the order of its letters are shown as codes instead.
#pragma once

#include <string>
#include <string_view>

namespace trembler {

/// One line for people. Control characters (C0, DEL, C1), bidirectional overrides, embeddings and isolates,
/// line and paragraph separators and invisible format characters become <U+001B> and the like; bytes that are
/// not UTF-8 become codes such as <9B>. All other text is unchanged. The result is UTF-8; applying visible()
/// again does not change it. Line feeds and tabs are replaced as well, so that one name cannot look like two
/// lines. Thread-safe.
[[nodiscard]] std::string visible(std::string_view text);

/// The same, but keeps line feeds and tabs: for text of several lines.
[[nodiscard]] std::string visibleLines(std::string_view text);

/// Whether there is a control character (C0 or DEL) in a text, such as a line feed or a tab.
[[nodiscard]] bool hasControlCharacter(std::string_view text);

/// How many bytes at the end of a text may be the beginning of an incomplete character: 0 to 3.
[[nodiscard]] std::size_t unfinishedCharacter(std::string_view text);

/// The bytes of the UTF-8 character with which a text begins: 1 to 4; 0 if it begins with none.
[[nodiscard]] std::size_t characterLength(std::string_view text);

/// A printed JSON document in which these characters are replaced by \u escapes, so that its meaning is
/// unchanged. Line feeds and tabs outside strings stay. Expects valid UTF-8.
[[nodiscard]] std::string escapedJson(std::string_view printed);

} // namespace trembler
