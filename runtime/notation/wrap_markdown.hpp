// Lines of prose in pages of Markdown that the program writes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace trembler {

/// The same page with lines of at most `width` characters, as in pages that are written by hand. Tables,
/// code, headings and pictures keep their lines, and text between backquotes is not broken; a word that is
/// longer than a line stays whole. The text of entries of lists is indented as it was. The page is UTF-8.
[[nodiscard]] std::string wrapMarkdown(std::string_view page, std::size_t width = 120);

} // namespace trembler
